// SPDX-License-Identifier: BSD-3-Clause
// What the estimator and the sensor check do differently while a planner lets feet step.
#include <boost/test/unit_test.hpp>

#include "estimator/contact/slip_detector.hpp"
#include "estimator/imu/imu_filter_input.hpp"
#include "robot_states.hpp"
#include "surefoot/state_estimator.hpp"
#include "tick/motion_check.hpp"

using namespace surefoot;

namespace {

const Eigen::Vector4d kLoads = Eigen::Vector4d::Constant(0.25);  // [m g] of each foot

constexpr double kPeriod = 0.002;

// The filter input of a resting robot whose IMU vibrates.
struct VibratingImu {
  Robot robot = quadruped();
  Dynamics dynamics{robot};
  InvariantFilter filter;
  ImuReading imu;
  ImuFilterInput preprocessor;

  VibratingImu() {
    dynamics.update(standing_state(robot).q, Eigen::VectorXd::Zero(18), Vector3::UnitZ());
    filter.reset(Quaternion::Identity(), Vector3::Zero(), Vector3::Zero(), FeetMatrix::Zero(), {});
    imu.gyroscope = imu.accelerometer = imu.quaternion = SensorVerdict::kGood;
  }
  // Return the input after `ticks` with an amplitude of `size` [m/s^2].
  ImuInput run(int ticks, double size, bool stepping) {
    ImuInput out;
    for (int k = 0; k < ticks; ++k) {
      const double value = k % 2 == 0 ? size : -size;
      imu.w_base = Vector3(0.05 * value, 0.0, 0.0);
      imu.f_base = Vector3(0.0, value, kGravity);
      out = preprocessor.update(Gains(), imu, filter, dynamics,
                                {Eigen::Vector4d::Ones(), stepping, !stepping}, kPeriod);
    }
    return out;
  }
};

// Return the push [m/s^2] that a resting robot estimates whose accelerometer reads 3 m/s^2 more
// than planned.
double estimated_push(bool stepping) {
  const Robot robot = quadruped();
  StateEstimator estimator(robot);
  Gains gains = robot.config().gains;
  gains.noise_foot_position = 0.01;  // the legs do not move, which contradicts the push
  estimator.set_gains(gains);
  LowState report = resting_sample(robot, 0);
  const auto run = [&](int ticks) {
    for (int k = 0; k < ticks; ++k) {
      report.tick += 2;
      BOOST_REQUIRE((estimator.update(report, kPeriod) == Status::kOk));
    }
  };
  run(500);
  estimator.set_planned_motion(Vector6::Zero(), Vector12::Zero(), Vector3::Zero());
  estimator.set_stepping(stepping);
  report.imu.accelerometer[0] = 3.0F;
  run(30);
  return (estimator.state().f_external - estimator.state().f_sustained).norm() / robot.mass();
}

// Return what MotionCheck finds if the feet turn under a body at rest, as four feet in the air can.
Status found_while_feet_turn(bool feet_stand) {
  const Robot robot = quadruped();
  StateEstimator estimator(robot);
  MotionCheck check;
  LowState report = resting_sample(robot, 0);
  Status found = Status::kOk;
  for (int k = 1; k <= 300 && found == Status::kOk; ++k) {
    const double time = k < 100 ? 0.0 : kPeriod * (k - 100);
    report.tick += 2;
    for (int leg = 0; leg < kLegs; ++leg) {
      const double sign = leg == FR_ || leg == FL_ ? 1.0 : -1.0;  // a turn about the vertical
      const double rest = robot.config().q_standing[kLegJoints * leg];
      report.motorState[kLegJoints * leg].q =
          float(rest + sign * 0.15 * (1.0 - std::cos(6.0 * time)));
      report.motorState[kLegJoints * leg].dq = float(sign * 0.9 * std::sin(6.0 * time));
    }
    estimator.set_stepping(!feet_stand);
    BOOST_REQUIRE((estimator.update(report, kPeriod) == Status::kOk));
    found = check.update(report, robot.config(), estimator, feet_stand, kPeriod);
  }
  return found;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(estimator_stepping)

BOOST_AUTO_TEST_CASE(vibration_of_a_stepping_robot_is_not_learnt_as_sensor_noise) {
  const double w2 = std::pow(Gains().noise_gyroscope, 2);
  const double f2 = std::pow(Gains().noise_accelerometer, 2);
  for (const bool stepping : {true, false}) {
    VibratingImu robot;
    robot.run(500, 10.0, stepping);
    const ImuInput calm = robot.run(10, 0.0, false);
    BOOST_TEST((calm.w_variance < 1.5 * w2) == stepping);
    BOOST_TEST((calm.f_variance < 1.5 * f2) == stepping);
    BOOST_TEST((calm.w_variance > 20.0 * w2) == !stepping);
    BOOST_TEST((calm.f_variance > 20.0 * f2) == !stepping);
  }
}

BOOST_AUTO_TEST_CASE(vibration_of_a_stepping_robot_counts_for_the_accelerometer_alone) {
  const auto input = [](double size, bool stepping) {
    return VibratingImu().run(200, size, stepping);
  };
  const ImuInput calm = input(0.0, true), vibrating = input(10.0, true);
  BOOST_TEST(vibrating.w_variance == calm.w_variance);
  BOOST_TEST(vibrating.f_variance > 100.0 * calm.f_variance);
  BOOST_TEST(input(10.0, false).w_variance > 10.0 * calm.w_variance);  // while the robot stands
}

BOOST_AUTO_TEST_CASE(stepping_robot_estimates_no_push) {
  BOOST_TEST(estimated_push(false) > 1.0);
  BOOST_TEST(estimated_push(true) == 0.0);
}

// The rules of standing feet report a slip in both cases.
BOOST_AUTO_TEST_CASE(sole_that_sinks_or_lifts_off_is_no_slip_if_the_feet_step) {
  const auto slip_after = [](const Vector3& velocity, double load, bool stepping) {
    SlipDetector slip;
    FeetMatrix v = FeetMatrix::Zero();
    v.col(RR_) = velocity;
    const Eigen::Vector4d contact = Eigen::Vector4d::Ones(), loads = load * contact;
    for (int k = 0; k < 0.15 / kPeriod; ++k) {
      slip.update(Gains(), {v, contact, loads, Vector3::UnitZ(), stepping}, kPeriod);
    }
    return slip.slip()[RR_];
  };
  const Vector3 sinking(0.0, 0.0, -0.5), sliding(0.5, 0.0, 0.0);
  BOOST_TEST(slip_after(sinking, 0.5, true) == 0.0);
  BOOST_TEST(slip_after(sinking, 0.5, false) == 1.0);
  BOOST_TEST(slip_after(sliding, 0.0, true) == 0.0);
  BOOST_TEST(slip_after(sliding, 0.0, false) == 1.0);
  BOOST_TEST(slip_after(sliding, 0.5, true) == 1.0);
}

BOOST_AUTO_TEST_CASE(slip_is_forgotten_at_lift_off_only_if_the_feet_step) {
  for (const bool stepping : {true, false}) {
    const Gains gains;
    SlipDetector slip;
    FeetMatrix v = FeetMatrix::Zero();
    Eigen::Vector4d contact = Eigen::Vector4d::Ones();
    const auto run = [&](double seconds) {
      const FootSlipInput input{v, contact, kLoads, Vector3::UnitZ(), stepping};
      for (int k = 0; k < seconds / kPeriod; ++k) slip.update(gains, input, kPeriod);
    };
    v(0, RR_) = 0.5;
    run(0.15);
    BOOST_TEST(slip.slip()[RR_] == 1.0);  // also if the feet step
    v.setZero();
    contact[RR_] = 0.0;
    run(0.1);
    contact[RR_] = 1.0;
    run(0.01);
    BOOST_TEST((slip.slip()[RR_] == 0.0) == stepping);
    BOOST_TEST((slip.friction(gains)[RR_] == 1.0) == stepping);
  }
}

BOOST_AUTO_TEST_CASE(feet_that_step_are_no_wrong_joint_sensor) {
  BOOST_TEST(names_wrong_sensor(found_while_feet_turn(true)));
  BOOST_TEST((found_while_feet_turn(false) == Status::kOk));
}

BOOST_AUTO_TEST_SUITE_END()
