// SPDX-License-Identifier: BSD-3-Clause
#include <boost/test/unit_test.hpp>

#include "capture_point_robot.hpp"
#include "reference/recovery_steps.hpp"

using namespace surefoot;

namespace {

constexpr double kDt = 0.002;
const Eigen::Vector4d kAllLoaded = Eigen::Vector4d::Ones();
const Eigen::Vector4d kFrontRightUp(0.0, 1.0, 1.0, 1.0);

struct RecoveryStepsFixture : CapturePointRobot {
  SupportFrame support;
  RecoverySteps steps;
  FeetMatrix feet;
  RecoveryStepsFixture() {
    gains.foot_step = 0.1;
    feet = contact_points(dynamics);
    support.latch(feet);
  }
  // Set a forward velocity that brings the capture point within `margin` [m] of the front feet.
  void lean_forwards(double margin) {
    const double front = std::min(feet(0, FR_), feet(0, FL_)) - dynamics.p_world_com().x();
    set_com_velocity(Vector3(omega() * (front - margin), 0.0, 0.0));
  }
  // Run one tick, as StandPlanner does.
  void tick(const Eigen::Vector4d& contact) {
    FeetMatrix seen = feet;
    Eigen::Vector4d standing = contact;
    steps.exclude_swing_feet(support, seen, standing);
    support.update(seen, standing, kDt);
    steps.update(gains, dynamics, feet, contact, support, kDt);
  }
  void wait(const Eigen::Vector4d& contact, double seconds) {
    for (double t = 0.0; t < seconds; t += kDt) tick(contact);
  }
  Vector3 target_position(int leg) const {
    return support.p_world_nominal_feet().col(leg) + steps.foot_offsets().col(leg);
  }
  double offset_length(int leg) const { return steps.foot_offsets().col(leg).head<2>().norm(); }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(recovery_steps)

BOOST_FIXTURE_TEST_CASE(lifted_foot_stays_over_its_nominal_position_inside_the_margin,
                        RecoveryStepsFixture) {
  lean_forwards(gains.edge_margin);
  wait(kFrontRightUp, 0.5);
  BOOST_TEST(steps.foot_offsets().isZero());
  lean_forwards(0.0);
  gains.foot_step = 0.0;
  wait(kFrontRightUp, 0.5);
  BOOST_TEST(steps.foot_offsets().isZero());
}

BOOST_FIXTURE_TEST_CASE(lifted_foot_near_the_edge_steps_toward_the_capture_point,
                        RecoveryStepsFixture) {
  lean_forwards(0.0);
  wait(kFrontRightUp, 0.05);
  BOOST_TEST(steps.foot_offsets()(2, FR_) > 0.0);  // lifted
  wait(kFrontRightUp, 0.5);
  const Vector3 displacement = steps.foot_offsets().col(FR_);
  BOOST_TEST(displacement.x() == gains.foot_step, boost::test_tools::tolerance(0.02));
  BOOST_TEST(std::abs(displacement.y()) < 0.2 * gains.foot_step);
  BOOST_TEST(displacement.z() < -0.01);  // and pressed down
  for (const int leg : {FL_, RR_, RL_}) BOOST_TEST(steps.foot_offsets().col(leg).isZero());
}

BOOST_FIXTURE_TEST_CASE(step_is_shorter_inside_the_edge_margin, RecoveryStepsFixture) {
  gains.foot_step = 0.5;  // longer than the step that is needed
  lean_forwards(0.0);
  wait(kFrontRightUp, 0.5);
  const double whole = offset_length(FR_);
  steps.reset();
  support.latch(feet);
  lean_forwards(0.5 * gains.edge_margin);
  wait(kFrontRightUp, 0.5);
  BOOST_TEST(offset_length(FR_) > 0.3 * whole);
  BOOST_TEST(offset_length(FR_) < 0.5 * whole);
}

// Feet that are not at their targets yet must not move the support frame, from which the targets
// are measured.
BOOST_FIXTURE_TEST_CASE(all_feet_step_without_contact_and_the_support_frame_stays,
                        RecoveryStepsFixture) {
  lean_forwards(0.0);
  const Vector3 origin = support.origin();
  wait(Eigen::Vector4d::Zero(), 0.05);
  BOOST_TEST((support.origin() - origin).norm() < 1e-6);
  for (int leg = 0; leg < kLegs; ++leg) {
    const Vector3 displacement = target_position(leg) - feet.col(leg);
    BOOST_TEST(displacement.x() > 0.05);
    BOOST_TEST(displacement.z() > 0.01);
  }
}

BOOST_FIXTURE_TEST_CASE(step_rotates_with_the_robot_heading, RecoveryStepsFixture) {
  lean_forwards(0.0);
  wait(kFrontRightUp, 0.1);
  const Vector3 ahead = steps.foot_offsets().col(FR_);
  const Quaternion turn(Eigen::AngleAxisd(2.0, Vector3::UnitZ()));
  state.q.head<3>() = turn * Vector3(state.q.head<3>());
  state.q.segment<4>(3) =
      (turn * Quaternion(state.q[6], state.q[3], state.q[4], state.q[5])).coeffs();
  dynamics.update(state.q, state.v, Vector3::UnitZ());
  feet = contact_points(dynamics);
  steps.reset();
  support.latch(feet);
  wait(kFrontRightUp, 0.1);
  BOOST_TEST((Vector3(steps.foot_offsets().col(FR_)) - turn * ahead).norm() < 1e-6);
}

BOOST_FIXTURE_TEST_CASE(landed_foot_stays_and_its_nominal_position_moves_to_it,
                        RecoveryStepsFixture) {
  lean_forwards(0.0);
  wait(kFrontRightUp, 0.1);
  const Vector3 landed = feet.col(FR_) + Vector3(0.06, -0.02, 0.0);
  feet.col(FR_) = landed;
  for (int k = 0; k < 500; ++k) {
    tick(kAllLoaded);
    BOOST_TEST((target_position(FR_) - landed).head<2>().norm() < 1e-4);
  }
  BOOST_TEST(offset_length(FR_) < 1e-6);
  // The centre of the feet has moved by a quarter of the step.
  BOOST_TEST((support.origin() - feet.rowwise().mean()).norm() < 1e-4);
}

BOOST_FIXTURE_TEST_CASE(capture_point_outside_the_support_lifts_one_loaded_foot,
                        RecoveryStepsFixture) {
  gains.foot_step = 0.3;
  move_capture_point_right(0.01);
  tick(kAllLoaded);
  BOOST_TEST(steps.is_lifting_off(RR_));
  for (const int leg : {FR_, FL_, RL_}) BOOST_TEST(!steps.is_lifting_off(leg));
  const Eigen::Vector4d hind_right_up(1.0, 1.0, 0.0, 1.0);
  tick(hind_right_up);
  BOOST_TEST(!steps.is_lifting_off(RR_));  // it has left the ground, and may carry load again
  wait(hind_right_up, 0.05);
  BOOST_TEST(steps.foot_offsets()(1, RR_) < -0.02);
  BOOST_TEST(steps.foot_offsets()(2, RR_) > 0.0);
}

BOOST_FIXTURE_TEST_CASE(capture_point_inside_the_support_lifts_no_loaded_foot,
                        RecoveryStepsFixture) {
  gains.foot_step = 0.3;
  move_capture_point_right(-0.01);
  wait(kAllLoaded, 0.5);
  BOOST_TEST(steps.foot_offsets().isZero());
}

// The foot stays unloaded only for a short time.
BOOST_FIXTURE_TEST_CASE(foot_that_fails_to_lift_returns_to_stance, RecoveryStepsFixture) {
  gains.foot_step = 0.3;
  move_capture_point_right(0.01);
  tick(kAllLoaded);
  BOOST_TEST(steps.is_lifting_off(RR_));
  move_capture_point_right(-0.1);
  wait(kAllLoaded, 0.3);
  BOOST_TEST(!steps.is_lifting_off(RR_));
  wait(kAllLoaded, 0.5);
  BOOST_TEST(offset_length(RR_) < 1e-3);
}

// The foot is not lifted again while the capture point is still outside.
BOOST_FIXTURE_TEST_CASE(foot_that_failed_to_lift_is_not_retried_while_still_outside,
                        RecoveryStepsFixture) {
  gains.foot_step = 0.3;
  move_capture_point_right(0.01);
  tick(kAllLoaded);
  BOOST_TEST(steps.foot_offsets()(2, RR_) > 0.0);
  int lifted = 0;
  for (int k = 0; k < 500; ++k) {
    tick(kAllLoaded);
    lifted += steps.is_lifting_off(RR_);
  }
  BOOST_TEST(lifted * kDt * omega() < 0.7);
  move_capture_point_right(-0.2);
  tick(kAllLoaded);
  move_capture_point_right(0.01);
  tick(kAllLoaded);
  BOOST_TEST(steps.is_lifting_off(RR_));
}

BOOST_FIXTURE_TEST_CASE(stopped_step_returns_to_zero_without_a_jump, RecoveryStepsFixture) {
  lean_forwards(0.0);
  wait(kFrontRightUp, 0.1);
  const double before = offset_length(FR_);
  BOOST_TEST(before > 0.0);
  steps.stop(kDt);
  BOOST_TEST(offset_length(FR_) > 0.9 * before);  // without a jump
  for (int k = 0; k < 1000; ++k) steps.stop(kDt);
  BOOST_TEST(offset_length(FR_) < 1e-3);
}

BOOST_AUTO_TEST_SUITE_END()
