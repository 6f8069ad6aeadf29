// SPDX-License-Identifier: BSD-3-Clause
#include <boost/test/unit_test.hpp>
#include <cstring>
#include <random>

#include "robot_states.hpp"
#include "surefoot/stand_controller.hpp"
#include "tick/controller_access.hpp"

using namespace surefoot;

namespace {

bool same(const LowCmd& a, const LowCmd& b) { return std::memcmp(&a, &b, sizeof(LowCmd)) == 0; }

bool torque_mode(const LowCmd& command) {
  bool good = true;
  for (int i = 0; i < kMotors; ++i) {
    const MotorCmd& m = command.motorCmd[i];
    good = good && m.mode == kModeServo && m.Kp == 0.0F && m.Kd == 0.0F &&
           m.q == static_cast<float>(PosStopF) && m.dq == static_cast<float>(VelStopF);
  }
  return good;
}

struct RunningController {
  Robot robot = quadruped();
  StandController controller{robot};
  std::uint32_t tick = 0;
  LowState report = resting_sample(robot, 0);
  LowCmd last;
  RunningController() {
    for (int i = 0; i < 10; ++i) last = step();
  }
  LowCmd step() {
    report.tick = tick;
    tick += 2;
    return controller.update(report);
  }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(stand_controller)

BOOST_FIXTURE_TEST_CASE(standing_robot_gets_static_torques_in_torque_mode, RunningController) {
  BOOST_TEST((controller.status() == Status::kOk));
  BOOST_TEST(torque_mode(last));
  for (int i = 0; i < kMotors; ++i) {
    BOOST_TEST(std::abs(last.motorCmd[i].tau - report.motorState[i].tauEst) < 0.5);
  }
  BOOST_TEST(std::abs(controller.solution().forces.row(2).sum() - robot.mass() * kGravity) < 2.0);
}

BOOST_FIXTURE_TEST_CASE(bad_sample_holds_the_command_for_10_ms_then_latches_damping,
                        RunningController) {
  report.imu.gyroscope[1] = std::nanf("");
  for (int i = 0; i < 5; ++i) {
    BOOST_TEST(same(step(), last));
    BOOST_TEST((controller.status() == Status::kNonFinite));
  }
  BOOST_TEST(motors_brake(step()));
  report.imu.gyroscope[1] = 0.0F;
  BOOST_TEST(motors_brake(step()));
  BOOST_TEST((controller.status() == Status::kDamping));
  BOOST_TEST((controller.fault() == Status::kNonFinite));
  controller.reset();
  BOOST_TEST(torque_mode(step()));
}

BOOST_FIXTURE_TEST_CASE(repeated_tick_is_stale, RunningController) {
  for (int i = 0; i < 5; ++i) {
    tick -= 2;
    report.tick = tick - 2;
    const LowCmd held = controller.update(report);
    tick += 2;
    BOOST_TEST(same(held, last));
    BOOST_TEST((controller.status() == Status::kStaleTick));
  }
  report.tick = tick - 2;
  BOOST_TEST(motors_brake(controller.update(report)));
}

// The robot has damped by itself meanwhile, and may not stand in its old pose.
BOOST_FIXTURE_TEST_CASE(long_sample_gap_latches_damping, RunningController) {
  tick += 90;
  BOOST_TEST(torque_mode(step()));
  tick += 5000;
  step();  // a single jump may be a wrong tick
  BOOST_TEST(motors_brake(step()));
  BOOST_TEST((controller.status() == Status::kDamping));
  BOOST_TEST((controller.fault() == Status::kStaleTick));
  controller.reset();
  BOOST_TEST(torque_mode(step()));
}

// Without torque measurements the estimator uses the planned torques. reset() must forget the plan.
BOOST_FIXTURE_TEST_CASE(reset_clears_the_planned_torques, RunningController) {
  for (int i = 0; i < kMotors; ++i) report.motorState[i].tauEst = 0.0F;
  for (int i = 0; i < 50; ++i) step();
  controller.reset();
  StandController fresh(robot);
  for (int i = 0; i < 10; ++i) {
    const LowCmd command = step();
    BOOST_TEST(same(command, fresh.update(report)));
  }
}

BOOST_FIXTURE_TEST_CASE(pending_gains_apply_at_once_when_damping_starts, RunningController) {
  Gains gains = robot.config().gains;
  gains.damping_kd = 20.0;
  controller.set_gains(gains);
  step();
  report.imu.gyroscope[1] = std::nanf("");
  for (int i = 0; i < 7; ++i) last = step();
  BOOST_TEST(motors_brake(last));
  BOOST_TEST(last.motorCmd[0].Kd == 20.0F);
}

BOOST_FIXTURE_TEST_CASE(duplicate_samples_do_not_advance_time, RunningController) {
  const auto turned = [&](int copies) {
    StandController turning(robot);
    ControllerAccess::end_sensor_check(turning);  // the legs do not turn with the gyroscope
    for (std::uint32_t k = 0; k <= 50; ++k) {
      LowState now = resting_sample(robot, 2 * k);
      now.imu.gyroscope = {0.0F, 0.0F, 1.0F};
      for (int copy = 0; copy < copies; ++copy) turning.update(now);
    }
    const Eigen::VectorXd q = turning.state().q;
    return 2.0 * std::atan2(q[5], q[6]);
  };
  BOOST_TEST(std::abs(turned(1) - 0.1) < 0.02);
  BOOST_TEST(std::abs(turned(2) - turned(1)) < 1e-9);
}

BOOST_FIXTURE_TEST_CASE(zero_quaternion_is_reported_and_control_continues, RunningController) {
  report.imu.quaternion = {0.0F, 0.0F, 0.0F, 0.0F};
  BOOST_TEST(torque_mode(step()));
  BOOST_TEST(is_usable(controller.status()));
  BOOST_TEST((controller.estimator_report().quaternion == SensorVerdict::kZero));
}

BOOST_FIXTURE_TEST_CASE(robot_on_its_back_is_fallen_and_damped, RunningController) {
  report.imu.quaternion = {0.0F, 1.0F, 0.0F, 0.0F};
  report.imu.accelerometer = {0.0F, 0.0F, static_cast<float>(-kGravity)};
  controller.reset();
  BOOST_TEST(motors_brake(step()));
  BOOST_TEST((controller.fault() == Status::kFallen));
}

BOOST_FIXTURE_TEST_CASE(implausible_gyroscope_rate_reaches_no_motor, RunningController) {
  report.imu.gyroscope = {0.0F, 3000.0F, 0.0F};
  BOOST_TEST(same(step(), last));
  BOOST_TEST((controller.status() == Status::kImplausible));
}

BOOST_FIXTURE_TEST_CASE(random_bytes_never_give_an_invalid_command, RunningController) {
  std::mt19937 generator(7);
  for (int round = 0; round < 20000; ++round) {
    LowState noise = resting_sample(robot, tick += 2);
    auto* bytes = reinterpret_cast<unsigned char*>(&noise);
    for (int k = 0; k < 1 + round % 40; ++k) bytes[22 + generator() % 867] = generator() & 0xFF;
    const LowCmd command = controller.update(noise);
    for (int i = 0; i < kMotors; ++i) {
      BOOST_REQUIRE(std::abs(command.motorCmd[i].tau) <= robot.config().tau_max[i] * 1.0001);
    }
    BOOST_REQUIRE((torque_mode(command) || motors_brake(command)));
    if (controller.status() == Status::kDamping) controller.reset();
  }
}

BOOST_AUTO_TEST_SUITE_END()
