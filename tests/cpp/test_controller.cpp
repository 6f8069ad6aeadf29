// SPDX-License-Identifier: BSD-3-Clause
// A Controller with a planner of the test. The tick itself: test_stand_controller.cpp.
#include <boost/test/unit_test.hpp>
#include <cstring>
#include <limits>

#include "lambda_planner.hpp"
#include "robot_states.hpp"
#include "surefoot/controller.hpp"
#include "surefoot/error.hpp"

using namespace surefoot;

namespace {

struct PlannedController {
  Robot robot = quadruped();
  std::shared_ptr<LambdaPlanner> planner = std::make_shared<LambdaPlanner>();
  Controller controller{robot, planner};
  LowState report = resting_sample(robot, 0);
  LowCmd step() {
    report.tick += 2;
    return controller.update(report);
  }
  void stand() {
    for (int tick = 0; tick < 10; ++tick) step();
    BOOST_TEST_REQUIRE((controller.status() == Status::kOk));
  }
  double torque_error(const LowCmd& command) const {
    double worst = 0.0;
    for (int i = 0; i < kMotors; ++i) {
      const double error = command.motorCmd[i].tau - report.motorState[i].tauEst;
      worst = std::max(worst, std::abs(error));
    }
    return worst;
  }
};

const double kNan = std::nan("");

}  // namespace

BOOST_AUTO_TEST_SUITE(controller)

BOOST_FIXTURE_TEST_CASE(robot_of_a_planner_stands, PlannedController) {
  stand();
  BOOST_TEST(torque_error(step()) < 0.5);
  BOOST_TEST((controller.fallback_level() == FallbackLevel::kSolved));
  BOOST_TEST(planner->calls == 11);
}

BOOST_FIXTURE_TEST_CASE(planner_input_has_the_state_of_the_tick, PlannedController) {
  stand();
  bool matches = false;
  planner->change = [&](const PlannerInput& input, Reference&) {
    const Quaternion R(input.R_world_base);
    const Eigen::Vector4d quat = input.state.q.segment<4>(3);
    const FeetMatrix feet = contact_points(robot, input.state.q);
    matches = std::abs(input.dt - 0.002) < 1e-9 && input.mass == robot.mass() &&
              input.lost_leg == -1 && input.gains == controller.active_gains() &&
              (input.p_com - center_of_mass(robot, input.state.q)).norm() < 1e-6 &&
              (input.p_feet - feet).norm() < 1e-3 && input.v_com.norm() < 0.01 &&
              input.v_feet.norm() < 0.01 && input.w_world_base.norm() < 0.01 &&
              std::abs(R.coeffs().dot(quat)) > 1.0 - 1e-9;
    return true;
  };
  step();
  BOOST_TEST(matches);
}

BOOST_FIXTURE_TEST_CASE(desired_acceleration_of_the_body_changes_the_forces, PlannedController) {
  stand();
  planner->change = [](const PlannerInput&, Reference& reference) {
    reference.a_com.z() = 1.0;
    return true;
  };
  step();
  const double weight = robot.mass() * kGravity;
  BOOST_TEST(controller.solution().forces.row(2).sum() > weight + 0.5 * robot.mass());
}

BOOST_FIXTURE_TEST_CASE(bad_reference_ends_one_tick_at_a_fallback_level, PlannedController) {
  const LambdaPlanner::Change changes[] = {
      [](const PlannerInput&, Reference&) { return false; },
      [](const PlannerInput&, Reference& r) { return r.p_com.x() = kNan, true; },
      [](const PlannerInput&, Reference& r) { return r.feet[RR_].p_world.z() = kNan, true; },
      [](const PlannerInput&, Reference& r) { return r.feet[FL_].load = kNan, true; },
      [](const PlannerInput&, Reference& r) { return r.ground_normal.x() = kNan, true; },
      [](const PlannerInput&, Reference& r) { return r.ground_normal *= -1.0, true; },
      [](const PlannerInput&, Reference& r) { return r.R_world_base.coeffs() *= 2.0, true; },
      [](const PlannerInput&, Reference& r) {
        r.a_com.y() = std::numeric_limits<double>::infinity();
        return true;
      },
      [](const PlannerInput&, Reference& r) { return r.posture.resize(3), true; },
  };
  stand();
  for (const LambdaPlanner::Change& change : changes) {
    planner->change = change;
    BOOST_TEST(torque_error(step()) < 0.5);
    BOOST_TEST((controller.status() == Status::kBadReference));
    BOOST_TEST((controller.fault() == Status::kBadReference));
    BOOST_TEST((controller.fallback_level() == FallbackLevel::kForces));
    // The next plan starts from the last valid reference.
    planner->change = nullptr;
    BOOST_TEST(torque_error(step()) < 0.5);
    BOOST_TEST((controller.status() == Status::kOk));
    BOOST_TEST((controller.fallback_level() == FallbackLevel::kSolved));
  }
}

BOOST_FIXTURE_TEST_CASE(bad_references_for_10_ms_latch_damping_until_reset, PlannedController) {
  stand();
  planner->change = [](const PlannerInput&, Reference&) { return false; };
  for (int tick = 0; tick < 5; ++tick) BOOST_TEST(!motors_brake(step()));
  BOOST_TEST(motors_brake(step()));
  BOOST_TEST((controller.status() == Status::kDamping));
  BOOST_TEST((controller.fault() == Status::kBadReference));
  planner->change = nullptr;
  BOOST_TEST(motors_brake(step()));
  controller.reset();
  BOOST_TEST(planner->calls == 0);
  stand();
}

BOOST_FIXTURE_TEST_CASE(motors_brake_until_the_first_valid_reference, PlannedController) {
  planner->change = [](const PlannerInput&, Reference&) { return false; };
  for (int tick = 0; tick < 20; ++tick) {
    BOOST_TEST(motors_brake(step()));
    BOOST_TEST((controller.status() == Status::kBadReference));
    BOOST_TEST((controller.fallback_level() == FallbackLevel::kDamping));
  }
  planner->change = nullptr;
  planner->calls = 0;  // write the pose again: nothing of a bad reference is kept
  stand();
}

BOOST_FIXTURE_TEST_CASE(lost_leg_has_no_load_whatever_the_planner_writes, PlannedController) {
  stand();
  controller.declare_leg_lost(RL_);
  int lost_leg = -1;
  planner->change = [&](const PlannerInput& input, Reference& reference) {
    lost_leg = input.lost_leg;
    reference.feet[RL_].stance = true;
    reference.feet[RL_].load = 1.0;
    return true;
  };
  step();
  BOOST_TEST(lost_leg == RL_);
  BOOST_TEST(!controller.reference().feet[RL_].stance);
  BOOST_TEST(controller.reference().feet[RL_].load == 0.0);
  BOOST_TEST(controller.reference().feet[FR_].stance);
  BOOST_TEST(controller.solution().forces.col(RL_).norm() < 1e-6);
  controller.reset();
  BOOST_TEST(controller.lost_leg() == -1);
  stand();
  BOOST_TEST(controller.reference().feet[RL_].stance);
}

BOOST_FIXTURE_TEST_CASE(first_reference_has_the_standing_pose_as_posture, PlannedController) {
  planner->change = [&](const PlannerInput&, Reference& reference) {
    for (int i = 0; i < kMotors; ++i) {
      const double standing = robot.q_standing()[robot.motor_to_q()[i]];
      if (reference.posture[robot.motor_to_v()[i] - 6] != standing) return false;
    }
    return true;
  };
  step();
  BOOST_TEST((controller.status() == Status::kOk));
}

BOOST_FIXTURE_TEST_CASE(controller_without_planner_is_refused, PlannedController) {
  BOOST_CHECK_EXCEPTION(Controller(robot, nullptr), Error, [](const Error& error) {
    return std::strstr(error.what(), "planner") != nullptr;
  });
}

BOOST_AUTO_TEST_SUITE_END()
