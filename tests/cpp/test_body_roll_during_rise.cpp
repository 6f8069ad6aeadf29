// SPDX-License-Identifier: BSD-3-Clause
// A lying body that rolls during a rise with a Supervisor.
#include <boost/test/unit_test.hpp>

#include "robot_states.hpp"
#include "supervisor/getting_up/joint_impedance.hpp"
#include "supervisor/getting_up/rise_plan.hpp"
#include "surefoot/supervisor.hpp"

using namespace surefoot;

namespace {

constexpr double kTick = 0.002;         // [s]
constexpr double kJointFriction = 0.5;  // [N.m.s/rad] of every joint
constexpr float kRollSpeed = 1.2F;      // [rad/s]
constexpr float kG = static_cast<float>(kGravity);

/// Massless left legs that hang free during the rise; the right legs have caught.
struct CaughtLegs {
  Robot robot = quadruped();
  RisePlan plan = plan_rise(robot, 50.0);
  JointImpedance legs{robot, plan, 50.0};
  Supervisor supervisor{robot, robot.config().gains};
  LowState report = resting_sample(robot, 0);
  LowCmd last = init_low_cmd();
  float roll_angle = 0.0F;  // [rad] right side down

  CaughtLegs() {
    for (int i = 0; i < kMotors; ++i) report.motorState[i].temperature = 30;
    for (int leg = 0; leg < kLegs; ++leg)
      report.motorState[3 * leg].q += leg % 2 == 0 ? -0.5F : 0.5F;
    for (int k = 0; k < 600; ++k) step();
    supervisor.arm();
    step();
    BOOST_REQUIRE((supervisor.request(Mode::kRise) == RequestStatus::kAccepted));
    step();
    BOOST_REQUIRE((supervisor.mode() == Mode::kRise));
  }
  void step(float turning = 0.0F) {
    report.tick += 2;
    roll_angle += static_cast<float>(kTick) * turning;
    const float noise = report.tick % 4 == 0 ? 1e-5F : -1e-5F;
    report.imu.gyroscope = {turning, 0.0F, noise};
    report.imu.quaternion = {std::cos(0.5F * roll_angle), std::sin(0.5F * roll_angle), 0.0F, 0.0F};
    report.imu.accelerometer = {noise, kG * std::sin(roll_angle), kG * std::cos(roll_angle)};
    legs.read(report);
    const Vector12 weight = legs.leg_gravity_torques();
    for (int i = 0; i < kMotors; ++i) {
      const MotorCmd& command = last.motorCmd[i];
      const bool free = supervisor.mode() == Mode::kRise && (i / kLegJoints) % 2 == FL_;
      const double dq =
          free ? (command.tau - weight[i]) / (command.Kd + kJointFriction) : 1e2 * noise;
      report.motorState[i].dq = static_cast<float>(dq);
      report.motorState[i].q += free ? static_cast<float>(kTick * dq) : 0.0F;
      report.motorState[i].tauEst = static_cast<float>(command.tau - command.Kd * dq);
    }
    last = supervisor.update(report);
  }
  void roll_to(float angle) {
    while (roll_angle < angle) step(kRollSpeed);
  }
  /// Return whether the left legs are weighed: folded, with the hip outward.
  bool is_weighing() const {
    const double out =
        std::copysign(report.motorState[FL_0].q - plan.folded[FL_0], plan.hip_outward_limit[FL_0]);
    return std::abs(report.motorState[FL_1].q - plan.folded[FL_1]) < 0.1 && std::abs(out) > 0.15 &&
           folded_once;
  }
  bool folded_once = false;
  /// Step until the left legs are weighed, at most 20 s.
  void fold() {
    for (int k = 0; k < 10000 && !is_weighing(); ++k) {
      step();
      folded_once = folded_once || std::abs(report.motorState[FL_0].q - plan.folded[FL_0]) < 0.05;
    }
    BOOST_REQUIRE(is_weighing());
  }
  /// Return the largest torque on a caught leg beyond its weight [N.m].
  double pull() {
    const Vector12 weight = legs.leg_gravity_torques();
    double most = 0.0;
    for (int i = FR_0; i <= FR_2; ++i)
      most = std::max(most, std::abs(last.motorCmd[i].tau - weight[i]));
    return most;
  }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(rolling_rise)

BOOST_FIXTURE_TEST_CASE(legs_are_released_when_the_body_rolls_during_weighing, CaughtLegs) {
  fold();
  const double pull_before_roll = pull();
  BOOST_TEST(pull_before_roll > 5.0);
  roll_to(0.5F);
  for (int k = 0; k < 100; ++k) step();
  BOOST_TEST((supervisor.mode() == Mode::kRise));
  BOOST_TEST(pull() < 0.2 * pull_before_roll);
  roll_to(0.76F);
  BOOST_TEST((supervisor.mode() == Mode::kDamping));
  BOOST_TEST((supervisor.damping_fault() == FaultId::kWiring));
}

BOOST_AUTO_TEST_SUITE_END()
