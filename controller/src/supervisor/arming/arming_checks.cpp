// SPDX-License-Identifier: BSD-3-Clause
#include "supervisor/arming/arming_checks.hpp"

#include <algorithm>
#include <cmath>

#include "supervisor/common/tilt.hpp"

namespace surefoot {

namespace {

// The constants are chosen by hand. The rows imu_bias, quaternion, packet_loss and unknown_pose of
// `surefoot faults` (bindings/surefoot/faults/rows) bracket the values: in these rows a value that
// "passes" must let the robot be armed, and a value that "is rejected" must not.
//
// Share of missing samples from which the check `link` fails. Larger than the 0.2 % of one lost
// sample per second at 500 Hz; 4 % is rejected.
constexpr double kMaxLoss = 0.01;
// [s] Time constant with which the counts of received and missing samples decay. Equal to the
// default of arming_time.
constexpr double kLossTime = 1.0;
// Error of a quaternion's norm from which the check fails. Larger than the rounding of a float
// (1e-7); 1 % is rejected.
constexpr double kQuaternionTolerance = 1e-3;
// [rad/s] Angular speed from the gyroscope from which the check fails: 0.02 passes, 0.1 is
// rejected.
constexpr double kMaxAngularSpeed = 0.05;
// [g] Error of the accelerometer's magnitude from which the check fails: 0.2 m/s^2 passes,
// 0.7 m/s^2 is rejected.
constexpr double kGravityTolerance = 0.05;
// [s] Time constant of the low-pass of gyroscope and accelerometer. Longer than the sample period,
// and shorter than the 0.5 s within which the checks must reject a fault.
constexpr double kImuFilterTime = 0.1;
// [rad] 10 degrees: angle between the verticals of IMU quaternion and accelerometer from which the
// check fails. Twice the error of the vendors' attitude filters (up to 5 degrees).
constexpr double kMaxAttitudeError = 0.1745;
// [rad] 25 degrees: tilt from which the check fails. Larger than the 20 degrees at which robots
// come to rest (sim/physics/lying_pose.py); 35 degrees are rejected. RolloverMonitor::kRollTilt is
// the same angle.
constexpr double kMaxTilt = 0.44;

}  // namespace

ArmingChecks::ArmingChecks(const Robot& robot, const ArmingLimits& limits)
    : robot_(robot), limits_(limits) {
  // kProgram: can the motors carry out the rise plan? The answer does not depend on samples.
  check_below(at(ArmingCheckId::kProgram), limits.max_holding_share, 1.0);
  set_blocking_fault(FaultId::kNone);
  set_conflict(false);
}

void ArmingChecks::set_blocking_fault(FaultId why) noexcept {
  ArmingCheck& check = at(ArmingCheckId::kFault);
  check.value = static_cast<int>(why);
  check.passed = why == FaultId::kNone;
}

void ArmingChecks::set_conflict(bool present) noexcept {
  ArmingCheck& check = at(ArmingCheckId::kConflict);
  check.value = present;
  check.passed = !present;
  if (present) clear_ready();
}

void ArmingChecks::update(const LowState& state, double step) noexcept {
  count_link(step);
  check_motors(state);
  check_imu(state, step);
  check_joints(state);
  check_order(state);
  check_feet(state);
  update_ready(step);
}

void ArmingChecks::count_missed() noexcept {
  missing_ += 1.0;
  ArmingCheck& link = at(ArmingCheckId::kLink);
  check_below(link, missing_ / (received_ + missing_), kMaxLoss);
  link.passed = false;  // this call brought no new sample
  clear_ready();
}

void ArmingChecks::add_link_counts(double received, double missing) noexcept {
  has_link_counts_ = true;
  received_ += received;
  // `missing` is negative if samples that were counted as missing have arrived late.
  missing_ = std::max(missing_ + missing, 0.0);
}

void ArmingChecks::count_link(double step) noexcept {
  const double decay = std::exp(-step / kLossTime);
  received_ *= decay;
  missing_ *= decay;
  if (!has_link_counts_) {
    // period_ estimates the period of the samples. A shorter step lowers period_ at once. If the
    // steps are longer, period_ grows by 0.1 % per sample (chosen: a factor of e in 1000 samples).
    if (step > 0.0) period_ = period_ > 0.0 ? std::min(1.001 * period_, step) : step;
    received_ += 1.0;
    if (period_ > 0.0) missing_ += std::max(std::round(step / period_) - 1.0, 0.0);
  }
  check_below(at(ArmingCheckId::kLink), missing_ / (received_ + missing_), kMaxLoss);
}

void ArmingChecks::check_motors(const LowState& state) noexcept {
  ArmingCheck &mode = at(ArmingCheckId::kMotorMode),
              &temperature_check = at(ArmingCheckId::kTemperature);
  mode = {};
  mode.passed = true;
  mode.limit = kModeServo;
  temperature_check = {};
  temperature_check.value = -300.0;  // [deg C] lower than any temperature
  for (int i = 0; i < kMotors; ++i) {
    const MotorState& motor = state.motorState[i];
    if (motor.mode != kModeServo && mode.passed) {
      mode.passed = false;
      mode.value = motor.mode;
      mode.motor = i;
    }
    if (motor.temperature > temperature_check.value) {
      temperature_check.motor = i;
      temperature_check.value = motor.temperature;
    }
  }
  check_below(temperature_check, temperature_check.value, limits_.temperature);
}

void ArmingChecks::check_imu(const LowState& state, double step) noexcept {
  const std::array<float, 4> q = state.imu.quaternion;  // the field is packed, so it is copied
  const std::array<float, 3> w = state.imu.gyroscope, a = state.imu.accelerometer;
  const double share = started_ ? -std::expm1(-step / kImuFilterTime) : 1.0;
  started_ = true;
  const Vector3 gyro(w[0], w[1], w[2]), accelerometer(a[0], a[1], a[2]);
  // Restart the low-pass after a NaN; otherwise its output would stay NaN for ever.
  const bool finite = gyro.allFinite() && accelerometer.allFinite();
  gyro_ = finite && gyro_.allFinite() ? Vector3(gyro_ + share * (gyro - gyro_)) : gyro;
  accelerometer_ = finite && accelerometer_.allFinite()
                       ? Vector3(accelerometer_ + share * (accelerometer - accelerometer_))
                       : accelerometer;
  const Eigen::Vector4d quaternion(q[0], q[1], q[2], q[3]);
  check_below(at(ArmingCheckId::kQuaternion), std::abs(quaternion.norm() - 1.0),
              kQuaternionTolerance);
  const Vector3 up_by_quaternion = quaternion_wxyz(quaternion).conjugate() * Vector3::UnitZ();
  check_below(at(ArmingCheckId::kAttitude), angle_between(up_by_quaternion, accelerometer_),
              kMaxAttitudeError);
  check_below(at(ArmingCheckId::kGyroscope), gyro_.norm(), kMaxAngularSpeed);
  check_below(at(ArmingCheckId::kAccelerometer), std::abs(accelerometer_.norm() / kGravity - 1.0),
              kGravityTolerance);
  const Vector3 up = quaternion_wxyz(robot_.config().quat_base_imu) * accelerometer_;
  check_below(at(ArmingCheckId::kTilt), tilt_angle(up.normalized()), kMaxTilt);
}

void ArmingChecks::update_ready(double step) noexcept {
  bool all = true;
  for (const ArmingCheck& check : report_.checks) all = all && (check.passed || !check.applies);
  report_.passed_for = all ? report_.passed_for + step : 0.0;
  report_.ready = all && report_.passed_for >= limits_.time;
}

}  // namespace surefoot
