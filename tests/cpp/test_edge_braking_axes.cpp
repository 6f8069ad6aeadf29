// SPDX-License-Identifier: BSD-3-Clause
#include <boost/test/unit_test.hpp>

#include "capture_point_robot.hpp"
#include "reference/capture_margin.hpp"
#include "surefoot/whole_body_controller.hpp"
#include "wbc/edge_braking_axes.hpp"

using namespace surefoot;

namespace {

struct PushedStance : CapturePointRobot {
  EdgeBrakingAxes axes() const {
    return edge_braking_axes(dynamics, state, reference, robot.mass());
  }
  // Push so that `share` = 1 moves the capture point to the front edge, if the push lasts 0.08 s.
  void push(double degrees, double share) {
    const double angle = degrees / 180.0 * M_PI;
    const double edge = contact_points(robot, state.q)(0, FL_) - dynamics.p_world_com().x();
    const double force = share * edge * omega() * robot.mass() / 0.08;
    state.f_external = force * Vector3(std::cos(angle), std::sin(angle), 0.0);
  }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(braking)

BOOST_FIXTURE_TEST_CASE(all_directions_have_equal_weight_inside_the_support, PushedStance) {
  BOOST_TEST(axes().along == 1.0);
  push(22.5, 0.5);
  BOOST_TEST(axes().along == 1.0);
  BOOST_TEST(axes().R.isIdentity());
}

BOOST_FIXTURE_TEST_CASE(push_over_the_front_edge_brakes_forward_motion_first, PushedStance) {
  push(15.0, 1.5);
  const EdgeBrakingAxes found = axes();
  BOOST_TEST((found.R.row(0) - Eigen::RowVector3d(1, 0, 0)).norm() < 1e-9);
  BOOST_TEST((found.R.row(1) - Eigen::RowVector3d(0, 1, 0)).norm() < 1e-9);
  BOOST_TEST(found.along < 0.05);
  BOOST_TEST(found.along > 0.0);
}

BOOST_FIXTURE_TEST_CASE(stepping_robot_brakes_all_directions_with_equal_weight, PushedStance) {
  push(15.0, 1.5);
  reference.stepping = true;
  BOOST_TEST(axes().along == 1.0);
}

BOOST_FIXTURE_TEST_CASE(push_over_the_side_edge_brakes_lateral_motion_first, PushedStance) {
  push(90.0, 1.5);
  const EdgeBrakingAxes found = axes();
  BOOST_TEST((found.R.row(0) - Eigen::RowVector3d(0, 1, 0)).norm() < 1e-9);
  BOOST_TEST(found.along < 0.05);
}

BOOST_FIXTURE_TEST_CASE(push_over_a_corner_keeps_weight_on_both_edges, PushedStance) {
  const Vector3 corner = contact_points(robot, state.q).col(FL_) - dynamics.p_world_com();
  set_com_velocity(1.3 * omega() * Vector3(corner.x(), corner.y(), 0.0));
  BOOST_TEST(axes().along > 0.5);
}

// The weight stays continuous as the capture point crosses an edge, and as it goes round a corner.
BOOST_FIXTURE_TEST_CASE(braking_weight_is_continuous_across_edges_and_corners, PushedStance) {
  const auto weight = [&] {  // weight of each direction, as a matrix
    const EdgeBrakingAxes found = axes();
    return Matrix3(found.R.transpose() * Vector3(1.0, found.along, 1.0).asDiagonal() * found.R);
  };
  for (const bool round : {false, true}) {
    Matrix3 before = weight();
    for (double s = 0.0; s < 1.0; s += 1e-3) {
      push(round ? 90.0 * s : 20.0, round ? 1.5 : 2.0 * s);
      if (s > 0.0) BOOST_TEST((weight() - before).norm() < 0.1);
      before = weight();
    }
  }
}

BOOST_FIXTURE_TEST_CASE(rotated_task_rows_request_the_same_acceleration, PushedStance) {
  BodyRows rows;
  rows.A_base.setRandom();
  rows.A_force.setRandom();
  rows.b.setRandom();
  rows.weight << 2.0, 2.0, 3.0;
  const BodyRows as_given = rows;
  push(22.5, 1.5);
  const EdgeBrakingAxes found = axes();
  found.apply_to(rows);
  BOOST_TEST((found.R.transpose() * rows.b - as_given.b).norm() < 1e-12);
  BOOST_TEST((found.R.transpose() * rows.A_force - as_given.A_force).norm() < 1e-12);
  BOOST_TEST((found.R.transpose() * rows.A_base - as_given.A_base).norm() < 1e-12);
  BOOST_TEST((rows.weight - Vector3(2.0, 2.0 * found.along, 3.0)).norm() < 1e-12);
}

BOOST_FIXTURE_TEST_CASE(two_loaded_feet_keep_equal_weights, PushedStance) {
  reference.feet[FR_].load = reference.feet[RL_].load = 0.0;
  push(22.5, 5.0);
  BOOST_TEST(axes().along == 1.0);
}

// A push over the front edge is braked by both front feet.
BOOST_FIXTURE_TEST_CASE(both_front_feet_brake_a_forward_push, PushedStance) {
  push(15.0, 1.5);
  for (const QpForm form : {QpForm::kCondensed, QpForm::kGeneral}) {
    WholeBodyController controller(robot, gains, {form});
    const Solution& solution = controller.update(state, controller.hold(state));
    BOOST_REQUIRE(is_usable(solution.status));
    const Vector3 sum = solution.forces.rowwise().sum();
    BOOST_TEST(sum.x() < 0.0);
    BOOST_TEST(std::abs(sum.y()) < 0.2 * std::abs(sum.x()));  // the push has a ratio of 0.27
    BOOST_TEST(solution.forces(2, FR_) > 0.5 * solution.forces(2, FL_));
  }
}

BOOST_AUTO_TEST_SUITE_END()
