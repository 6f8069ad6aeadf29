// SPDX-License-Identifier: BSD-3-Clause
#include "low_state_check.hpp"

#include <cmath>

namespace surefoot {

namespace {

constexpr double kUnit = 0.05;           // off unit length that is still renormalised
constexpr double kAbsurd = 1e4;          // in any unit
constexpr double kRate = 40.0;           // [rad/s] gyroscopes clip at 35
constexpr double kAcceleration = 200.0;  // [m/s^2] accelerometers clip at 157
constexpr double kJointMargin = 1.0;     // [rad] a folded calf rests beyond its limit
constexpr double kSpeedFactor = 2.0;     // of the motor's no-load speed
constexpr double kTorqueFactor = 3.0;    // of the motor's greatest torque

// Keeps the worst that was seen; comparisons are written so that NaN fails them.
struct Judge {
  Status status = Status::kOk;
  void operator()(double value, double lower, double upper) noexcept {
    if (!(std::abs(value) <= kAbsurd)) {
      status = Status::kNonFinite;
    } else if (!(value >= lower && value <= upper) && status == Status::kOk) {
      status = Status::kImplausible;
    }
  }
  void operator()(double value, double size) noexcept { (*this)(value, -size, size); }
};

}  // namespace

Status check_low_state(const LowState& state, const RobotConfig& config) noexcept {
  // Packed fields are not aligned: copy them before indexing.
  const std::array<float, 4> quaternion = state.imu.quaternion;
  const std::array<float, 3> gyroscope = state.imu.gyroscope;
  const std::array<float, 3> accelerometer = state.imu.accelerometer;
  Judge judge;
  for (const float value : quaternion) judge(value, kAbsurd);
  for (const float value : gyroscope) judge(value, kRate);
  for (const float value : accelerometer) judge(value, kAcceleration);
  for (int i = 0; i < kMotors; ++i) {
    const MotorState& motor = state.motorState[i];
    judge(motor.q, config.q_lower[i] - kJointMargin, config.q_upper[i] + kJointMargin);
    judge(motor.dq, kSpeedFactor * config.no_load_speed[i]);
    judge(motor.tauEst, kTorqueFactor * config.tau_max[i]);
  }
  return judge.status;
}

bool has_quaternion(const IMU& imu) noexcept {
  const std::array<float, 4> q = imu.quaternion;  // packed: copied
  return std::abs(std::hypot(std::hypot(q[0], q[1]), std::hypot(q[2], q[3])) - 1.0) <= kUnit;
}

}  // namespace surefoot
