// SPDX-License-Identifier: BSD-3-Clause
#include <boost/test/unit_test.hpp>

#include "leaning.hpp"
#include "reference/foot_steps.hpp"

using namespace surefoot;

namespace {

constexpr double kDt = 0.002;
const Eigen::Vector4d kAll = Eigen::Vector4d::Ones();
const Eigen::Vector4d kFrontRightUp(0.0, 1.0, 1.0, 1.0);

struct Stepping : Leaning {
  SupportFrame support;
  FootSteps steps;
  FeetMatrix feet;
  Stepping() {
    gains.foot_step = 0.1;
    feet = contact_points(dynamics);
    support.latch(feet);
  }
  // Speed forwards that brings the capture point within `margin` of the front feet.
  void lean_forwards(double margin) {
    const double front = std::min(feet(0, FR_), feet(0, FL_)) - dynamics.p_world_com().x();
    lean(Vector3(omega() * (front - margin), 0.0, 0.0));
  }
  // As StandReference does in a tick.
  void tick(const Eigen::Vector4d& contact) {
    FeetMatrix seen = feet;
    Eigen::Vector4d standing = contact;
    steps.hide_swinging(support, seen, standing);
    support.update(seen, standing, kDt);
    steps.update(gains, dynamics, feet, contact, support, kDt);
  }
  void wait(const Eigen::Vector4d& contact, double seconds) {
    for (double t = 0.0; t < seconds; t += kDt) tick(contact);
  }
  Vector3 belongs(int leg) const {
    return support.p_world_places().col(leg) + steps.way().col(leg);
  }
  double goes(int leg) const { return steps.way().col(leg).head<2>().norm(); }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(foot_steps)

BOOST_FIXTURE_TEST_CASE(a_foot_in_the_air_stays_over_its_place_while_that_can_be_afforded,
                        Stepping) {
  lean_forwards(gains.edge_margin);
  wait(kFrontRightUp, 0.5);
  BOOST_TEST(steps.way().isZero());
  lean_forwards(0.0);
  gains.foot_step = 0.0;
  wait(kFrontRightUp, 0.5);
  BOOST_TEST(steps.way().isZero());
}

BOOST_FIXTURE_TEST_CASE(near_the_edge_it_steps_where_the_capture_point_goes_and_no_farther,
                        Stepping) {
  lean_forwards(0.0);
  wait(kFrontRightUp, 0.05);
  BOOST_TEST(steps.way()(2, FR_) > 0.0);  // lifted
  wait(kFrontRightUp, 0.5);
  const Vector3 way = steps.way().col(FR_);
  BOOST_TEST(way.x() == gains.foot_step, boost::test_tools::tolerance(0.02));
  BOOST_TEST(std::abs(way.y()) < 0.2 * gains.foot_step);
  BOOST_TEST(way.z() < -0.01);  // and pressed down
  for (const int leg : {FL_, RR_, RL_}) BOOST_TEST(steps.way().col(leg).isZero());
}

BOOST_FIXTURE_TEST_CASE(it_steps_less_far_inside_the_edge, Stepping) {
  gains.foot_step = 0.5;  // more than is asked
  lean_forwards(0.0);
  wait(kFrontRightUp, 0.5);
  const double whole = goes(FR_);
  steps.reset();
  support.latch(feet);
  lean_forwards(0.5 * gains.edge_margin);
  wait(kFrontRightUp, 0.5);
  BOOST_TEST(goes(FR_) > 0.3 * whole);
  BOOST_TEST(goes(FR_) < 0.5 * whole);
}

// Feet that are not where they belong yet must not move the frame that says where that is.
BOOST_FIXTURE_TEST_CASE(thrown_off_the_ground_altogether_all_step_and_the_frame_stays, Stepping) {
  lean_forwards(0.0);
  const Vector3 origin = support.origin();
  wait(Eigen::Vector4d::Zero(), 0.05);
  BOOST_TEST((support.origin() - origin).norm() < 1e-6);
  for (int leg = 0; leg < kLegs; ++leg) {
    const Vector3 way = belongs(leg) - feet.col(leg);
    BOOST_TEST(way.x() > 0.05);
    BOOST_TEST(way.z() > 0.01);
  }
}

BOOST_FIXTURE_TEST_CASE(it_steps_the_same_whichever_way_the_robot_faces, Stepping) {
  lean_forwards(0.0);
  wait(kFrontRightUp, 0.1);
  const Vector3 ahead = steps.way().col(FR_);
  const Quaternion turn(Eigen::AngleAxisd(2.0, Vector3::UnitZ()));
  state.q.head<3>() = turn * Vector3(state.q.head<3>());
  state.q.segment<4>(3) =
      (turn * Quaternion(state.q[6], state.q[3], state.q[4], state.q[5])).coeffs();
  dynamics.update(state.q, state.v, Vector3::UnitZ());
  feet = contact_points(dynamics);
  steps.reset();
  support.latch(feet);
  wait(kFrontRightUp, 0.1);
  BOOST_TEST((Vector3(steps.way().col(FR_)) - turn * ahead).norm() < 1e-6);
}

BOOST_FIXTURE_TEST_CASE(where_it_lands_it_stays_and_its_place_comes_to_it, Stepping) {
  lean_forwards(0.0);
  wait(kFrontRightUp, 0.1);
  const Vector3 landed = feet.col(FR_) + Vector3(0.06, -0.02, 0.0);
  feet.col(FR_) = landed;
  for (int k = 0; k < 500; ++k) {
    tick(kAll);
    BOOST_TEST((belongs(FR_) - landed).head<2>().norm() < 1e-4);
  }
  BOOST_TEST(goes(FR_) < 1e-6);
  // The middle of the feet has moved along by a quarter.
  BOOST_TEST((support.origin() - feet.rowwise().mean()).norm() < 1e-4);
}

BOOST_FIXTURE_TEST_CASE(with_the_capture_point_outside_one_that_bears_steps, Stepping) {
  gains.foot_step = 0.3;
  lean_right(0.01);
  tick(kAll);
  BOOST_TEST(steps.lifts(RR_));
  for (const int leg : {FR_, FL_, RL_}) BOOST_TEST(!steps.lifts(leg));
  const Eigen::Vector4d hind_right_up(1.0, 1.0, 0.0, 1.0);
  tick(hind_right_up);
  BOOST_TEST(!steps.lifts(RR_));  // it has left, and would bear again
  wait(hind_right_up, 0.05);
  BOOST_TEST(steps.way()(1, RR_) < -0.02);
  BOOST_TEST(steps.way()(2, RR_) > 0.0);
}

BOOST_FIXTURE_TEST_CASE(inside_none_that_bears_steps, Stepping) {
  gains.foot_step = 0.3;
  lean_right(-0.01);
  wait(kAll, 0.5);
  BOOST_TEST(steps.way().isZero());
}

// It is not left without its load for long.
BOOST_FIXTURE_TEST_CASE(one_that_does_not_leave_the_ground_stands_again, Stepping) {
  gains.foot_step = 0.3;
  lean_right(0.01);
  tick(kAll);
  BOOST_TEST(steps.lifts(RR_));
  lean_right(-0.1);
  wait(kAll, 0.3);
  BOOST_TEST(!steps.lifts(RR_));
  wait(kAll, 0.5);
  BOOST_TEST(goes(RR_) < 1e-3);
}

// Nor is it tried again and again, with the capture point still where it was.
BOOST_FIXTURE_TEST_CASE(one_that_did_not_leave_the_ground_is_left_in_peace, Stepping) {
  gains.foot_step = 0.3;
  lean_right(0.01);
  tick(kAll);
  BOOST_TEST(steps.way()(2, RR_) > 0.0);
  int lifted = 0;
  for (int k = 0; k < 500; ++k) {
    tick(kAll);
    lifted += steps.lifts(RR_);
  }
  BOOST_TEST(lifted * kDt * omega() < 0.7);
  lean_right(-0.2);
  tick(kAll);
  lean_right(0.01);
  tick(kAll);
  BOOST_TEST(steps.lifts(RR_));
}

BOOST_FIXTURE_TEST_CASE(a_foot_that_is_not_to_step_any_more_comes_back, Stepping) {
  lean_forwards(0.0);
  wait(kFrontRightUp, 0.1);
  const double before = goes(FR_);
  BOOST_TEST(before > 0.0);
  steps.stop(kDt);
  BOOST_TEST(goes(FR_) > 0.9 * before);  // by no jump
  for (int k = 0; k < 1000; ++k) steps.stop(kDt);
  BOOST_TEST(goes(FR_) < 1e-3);
}

BOOST_AUTO_TEST_SUITE_END()
