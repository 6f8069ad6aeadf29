// SPDX-License-Identifier: BSD-3-Clause
#include "supervisor/arming.hpp"

#include <algorithm>
#include <cmath>

#include "supervisor/lean.hpp"

namespace surefoot {

namespace {

constexpr double kLoss = 0.01;     // share of reports that may be missing
constexpr double kWindow = 1.0;    // [s] over which that is counted
constexpr double kUnit = 1e-3;     // that a quaternion may be off unit length: float's rounding
constexpr double kTurning = 0.05;  // [rad/s]
constexpr double kGravityShare = 0.05;  // that |a| may be off g
constexpr double kSmoothing = 0.1;      // [s] over which the IMU's noise is averaged
// [rad] 10 degrees between attitude and accelerometer: vendors' filters lean by 5 of them.
constexpr double kApart = 0.1745;
constexpr double kLevel = 0.44;  // [rad] 25 degrees: what a robot gets up from, and a little

}  // namespace

Arming::Arming(const Robot& robot, const ArmingLimits& limits) : robot_(robot), limits_(limits) {
  expect_below(at(ArmingCheckId::kProgram), limits.torque_share, 1.0);
  keep_down(FaultId::kNone);
}

void Arming::keep_down(FaultId why) noexcept {
  ArmingCheck& check = at(ArmingCheckId::kFault);
  check.value = static_cast<int>(why);
  check.passed = why == FaultId::kNone;
}

void Arming::update(const LowState& state, double step) noexcept {
  count_link(step);
  check_motors(state);
  check_imu(state, step);
  check_joints(state);
  check_order(state);
  check_feet(state);
  conclude(step);
}

void Arming::missed() noexcept {
  missing_ += 1.0;
  ArmingCheck& link = at(ArmingCheckId::kLink);
  expect_below(link, missing_ / (come_ + missing_), kLoss);
  link.passed = false;  // fresh is what comes now
  distrust();
}

void Arming::count(double come, double missing) noexcept {
  told_ = true;
  come_ += come;
  missing_ = std::max(missing_ + missing, 0.0);  // what was given up may come after all
}

void Arming::count_link(double step) noexcept {
  const double fade = std::exp(-step / kWindow);
  come_ *= fade;
  missing_ *= fade;
  if (!told_) {
    // The shortest step of late is a period: it follows a faster link at once, a slower one in
    // time.
    if (step > 0.0) period_ = period_ > 0.0 ? std::min(1.001 * period_, step) : step;
    come_ += 1.0;
    if (period_ > 0.0) missing_ += std::max(std::round(step / period_) - 1.0, 0.0);
  }
  expect_below(at(ArmingCheckId::kLink), missing_ / (come_ + missing_), kLoss);
}

void Arming::check_motors(const LowState& state) noexcept {
  ArmingCheck &mode = at(ArmingCheckId::kMotorMode), &heat = at(ArmingCheckId::kTemperature);
  mode = {};
  mode.passed = true;
  mode.limit = kModeServo;
  heat = {};
  heat.value = -300.0;
  for (int i = 0; i < kMotors; ++i) {
    const MotorState& motor = state.motorState[i];
    if (motor.mode != kModeServo && mode.passed) {
      mode.passed = false;
      mode.value = motor.mode;
      mode.motor = i;
    }
    if (motor.temperature > heat.value) {
      heat.motor = i;
      heat.value = motor.temperature;
    }
  }
  expect_below(heat, heat.value, limits_.temperature);
}

void Arming::check_imu(const LowState& state, double step) noexcept {
  const std::array<float, 4> q = state.imu.quaternion;  // packed: copied
  const std::array<float, 3> w = state.imu.gyroscope, a = state.imu.accelerometer;
  const double share = started_ ? -std::expm1(-step / kSmoothing) : 1.0;
  started_ = true;
  const Vector3 gyro(w[0], w[1], w[2]), accelerometer(a[0], a[1], a[2]);
  // What is no number must not stay in the average for ever.
  const bool numbers = gyro.allFinite() && accelerometer.allFinite();
  gyro_ = numbers && gyro_.allFinite() ? Vector3(gyro_ + share * (gyro - gyro_)) : gyro;
  accelerometer_ = numbers && accelerometer_.allFinite()
                       ? Vector3(accelerometer_ + share * (accelerometer - accelerometer_))
                       : accelerometer;
  const Eigen::Vector4d quaternion(q[0], q[1], q[2], q[3]);
  expect_below(at(ArmingCheckId::kQuaternion), std::abs(quaternion.norm() - 1.0), kUnit);
  const Vector3 claimed = quaternion_wxyz(quaternion).conjugate() * Vector3::UnitZ();
  expect_below(at(ArmingCheckId::kAttitude), angle_between(claimed, accelerometer_), kApart);
  expect_below(at(ArmingCheckId::kGyroscope), gyro_.norm(), kTurning);
  expect_below(at(ArmingCheckId::kAccelerometer), std::abs(accelerometer_.norm() / kGravity - 1.0),
               kGravityShare);
  const Vector3 up = quaternion_wxyz(robot_.config().quat_base_imu) * accelerometer_;
  expect_below(at(ArmingCheckId::kTilt), lean(up.normalized()), kLevel);
}

void Arming::conclude(double step) noexcept {
  bool all = true;
  for (const ArmingCheck& check : report_.checks) all = all && (check.passed || !check.applies);
  report_.held = all ? report_.held + step : 0.0;
  report_.ready = all && report_.held >= limits_.time;
}

}  // namespace surefoot
