// SPDX-License-Identifier: BSD-3-Clause
#include <boost/test/unit_test.hpp>

#include "capture_point_robot.hpp"
#include "reference/capture_margin.hpp"
#include "wbc/hold_down.hpp"
#include "wbc/qp_terms_writer.hpp"
#include "wbc/support_edge.hpp"

using namespace surefoot;

namespace {

struct HoldDown : CapturePointRobot {
  Eigen::Vector4d forces() const {
    return hold_down_forces(gains, weight, edge_fade(gains, dynamics, reference), state.contact,
                            reference);
  }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(hold_down)

BOOST_FIXTURE_TEST_CASE(hold_down_force_fades_to_zero_at_the_support_edge, HoldDown) {
  const double edge = contact_points(robot, state.q)(1, FL_);
  for (double y = 0.0; y < edge + 0.05; y += 0.002) {
    set_com_velocity(Vector3(0.0, (y - dynamics.p_world_com().y()) * omega(), 0.0));
    const double margin = edge - y;
    BOOST_TEST(std::abs(capture_margin(dynamics, reference) - margin) < 1e-9);
    const double fade = std::min(std::max(margin / gains.edge_margin, 0.0), 1.0);
    BOOST_TEST((forces().array() - gains.hold_down * weight * fade).abs().maxCoeff() < 1e-9);
  }
  BOOST_TEST(forces().maxCoeff() == 0.0);
}

BOOST_FIXTURE_TEST_CASE(capture_margin_does_not_depend_on_heading, HoldDown) {
  set_com_velocity(Vector3(0.1, 0.15, 0.0));
  const double margin = capture_margin(dynamics, reference);
  BOOST_TEST(margin > 0.0);
  for (double yaw = 0.0; yaw < 6.3; yaw += 0.3) {
    const Quaternion R = exp_so3(Vector3(0.0, 0.0, yaw));
    state.q.segment<4>(3) = R.coeffs();
    set_com_velocity(R * Vector3(0.1, 0.15, 0.0));
    BOOST_TEST(std::abs(capture_margin(dynamics, reference) - margin) < 1e-9);
  }
}

// The next step catches the body, so the capture point may be anywhere.
BOOST_FIXTURE_TEST_CASE(stepping_reference_has_no_support_edge, HoldDown) {
  set_com_velocity(Vector3(0.0, 5.0, 0.0));
  BOOST_TEST(capture_margin(dynamics, reference) < 0.0);
  reference.stepping = true;
  BOOST_TEST(std::isinf(capture_margin(dynamics, reference)));
  BOOST_TEST(edge_fade(gains, dynamics, reference) == 1.0);
}

BOOST_FIXTURE_TEST_CASE(swing_feet_and_lifted_feet_get_no_hold_down_force, HoldDown) {
  set_com_velocity(Vector3(0.25, -0.2, 0.0));
  gains.edge_margin = 0.03;
  reference.feet[RL_].stance = false;  // the capture point is inside the triangle of the others
  reference.feet[FL_].load = 0.25;
  state.contact[FR_] = 0.0;
  const Eigen::Vector4d f = forces();
  BOOST_TEST(capture_margin(dynamics, reference) > gains.edge_margin);
  BOOST_TEST(f[RL_] == 0.0);
  BOOST_TEST(f[FR_] == 0.0);
  BOOST_TEST(std::abs(f[FL_] - 0.25 * gains.hold_down * weight) < 1e-9);
  BOOST_TEST(std::abs(f[RR_] - gains.hold_down * weight) < 1e-9);
  reference.feet[FR_].load = 0.0;  // two feet have no support edge
  BOOST_TEST(std::abs(forces()[RR_] - gains.hold_down * weight) < 1e-9);
  set_com_velocity(Vector3(2.0, 2.0, 0.0));
  BOOST_TEST(std::abs(forces()[RR_] - gains.hold_down * weight) < 1e-9);
}

BOOST_FIXTURE_TEST_CASE(walking_robot_has_its_own_hold_down, HoldDown) {
  reference.stepping = true;
  gains.walk_hold_down = 2.0 * gains.hold_down;
  BOOST_TEST(std::abs(forces()[FR_] - gains.hold_down * weight) < 1e-9);
  reference.feet[FL_].stance = false;
  BOOST_TEST(std::abs(forces()[FR_] - gains.walk_hold_down * weight) < 1e-9);
}

BOOST_FIXTURE_TEST_CASE(hold_down_keeps_force_on_a_foot_the_tasks_would_lift, HoldDown) {
  for (const QpForm form : {QpForm::kCondensed, QpForm::kGeneral}) {
    for (const double share : {0.0, gains.hold_down}) {
      Gains g = gains;
      g.hold_down = share;
      WholeBodyController controller(robot, g, {form});
      Reference r = controller.hold(state);
      r.alpha_world_base = Vector3(120.0, 0.0, 0.0);  // tilts the body onto its right feet
      r.a_com.z() = -6.0;
      const Solution& s = controller.update(state, r);
      BOOST_REQUIRE(is_usable(s.status));
      const double least = s.forces.row(2).minCoeff();
      BOOST_TEST((share > 0.0 ? std::abs(least - share * weight) : least) < 0.05);
      BOOST_TEST(s.hold_down_violation < 0.05);
    }
  }
}

// The reference requests a fast descent. At the edge the feet must keep load, because unloaded feet
// cannot brake.
BOOST_FIXTURE_TEST_CASE(feet_keep_edge_load_at_the_edge_during_a_downward_request, HoldDown) {
  for (const QpForm form : {QpForm::kCondensed, QpForm::kGeneral}) {
    for (const double sway : {0.0, 0.8}) {
      WholeBodyController controller(robot, gains, {form});
      Reference r = controller.hold(state);
      r.a_com.z() = -30.0;
      r.v_com.y() = sway;  // no horizontal acceleration is requested
      RobotState leaning = state;
      leaning.v.y() = sway;
      const Solution& s = controller.update(leaning, r);
      BOOST_REQUIRE(is_usable(s.status));
      const double load = s.forces.row(2).sum() / weight;
      if (sway == 0.0) {
        BOOST_TEST(load < 4.0 * gains.hold_down + 0.02);  // only the hold-down forces
      } else {
        BOOST_TEST(load > gains.edge_load - 0.02);
        BOOST_TEST(load < 0.9);  // loaded, but less than in a stand
      }
    }
  }
}

// The force that turns the body back is missing for braking, so at the edge it turns back slowly.
BOOST_FIXTURE_TEST_CASE(tilt_correction_is_bounded_at_the_edge, HoldDown) {
  const double length = 0.3, slowly = kGravity / length;
  BodyAcceleration desired;
  desired.alpha = Vector3(-300.0, 400.0, 50.0);
  const Vector3 requested = desired.alpha;
  bound_at_edge(gains, 1.0, length, 0.0, desired);
  BOOST_TEST((desired.alpha == requested));
  double before = std::numeric_limits<double>::infinity();
  for (double fade = 1.0; fade >= 0.0; fade -= 0.1) {
    bound_at_edge(gains, fade, length, 0.0, desired);
    const double turning = desired.alpha.head<2>().norm();
    BOOST_TEST(turning <= before);
    BOOST_TEST(std::abs(desired.alpha.x() * requested.y() - desired.alpha.y() * requested.x()) <
               1e-9);
    before = turning;
  }
  BOOST_TEST(desired.alpha.z() == requested.z());
  bound_at_edge(gains, 0.0, length, 0.0, desired);
  BOOST_TEST(desired.alpha.head<2>().norm() == slowly, boost::test_tools::tolerance(1e-9));
  desired.alpha = Vector3(0.5 * slowly, 0.0, 0.0);
  bound_at_edge(gains, 0.0, length, 0.0, desired);
  BOOST_TEST(desired.alpha.x() == 0.5 * slowly);
}

// Feet that turn the body back also push it up, and a body in the air cannot brake.
BOOST_FIXTURE_TEST_CASE(tilt_correction_is_zero_while_the_body_rises_fast, HoldDown) {
  const double length = 0.3;
  const Vector3 requested(-300.0, 400.0, 50.0);
  const auto turning = [&](double v_up) {
    BodyAcceleration desired;
    desired.alpha = 1e6 * requested;
    bound_at_edge(gains, 0.0, length, v_up, desired);
    BOOST_TEST(desired.alpha.z() == 1e6 * requested.z());
    return desired.alpha.head<2>().norm() * length / kGravity;
  };
  const auto close = boost::test_tools::tolerance(1e-9);
  BOOST_TEST(turning(2.0) == 1.0, close);  // default edge_rise: full tilt correction
  gains.edge_rise = 0.8;
  BOOST_TEST(turning(-1.0) == 1.0, close);
  BOOST_TEST(turning(0.3) == 1.0, close);
  BOOST_TEST(turning(0.55) == 0.5, close);
  BOOST_TEST(turning(0.8) == 0.0);
  BOOST_TEST(turning(2.0) == 0.0);
}

// Inside the support a body that was pushed up must come down. At the edge, braking is more
// important than height and tilt.
BOOST_FIXTURE_TEST_CASE(height_and_tilt_weights_decrease_only_at_the_edge, HoldDown) {
  gains.edge_height = 0.2;
  gains.edge_tilt = 0.1;
  QpTermsWriter writer(robot);
  const double edge = contact_points(robot, state.q)(1, FL_) - dynamics.p_world_com().y();
  for (const double fade : {0.0, 0.5, 1.0}) {
    set_com_velocity(Vector3(0.0, (edge - fade * gains.edge_margin) * omega(), 0.0));
    const auto softness = Eigen::Vector4d::Zero();
    BOOST_REQUIRE(
        (writer.write(gains, dynamics, state, reference, softness, nullptr) == Status::kOk));
    const auto& [position, orientation, momentum] = writer.terms().body;
    const double height = gains.weight_com_vertical * (fade + (1.0 - fade) * gains.edge_height);
    const double tilt = gains.weight_base_tilt * (fade + (1.0 - fade) * gains.edge_tilt);
    BOOST_TEST(position.weight[2] == height, boost::test_tools::tolerance(1e-9));
    BOOST_TEST(orientation.weight[0] == tilt, boost::test_tools::tolerance(1e-9));
    BOOST_TEST(orientation.weight[1] == tilt, boost::test_tools::tolerance(1e-9));
    BOOST_TEST(orientation.weight[2] == gains.weight_base_yaw);
  }
}

BOOST_AUTO_TEST_SUITE_END()
