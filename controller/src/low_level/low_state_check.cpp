// SPDX-License-Identifier: BSD-3-Clause
#include "low_level/low_state_check.hpp"

#include <cmath>

namespace surefoot {

namespace {

// Limits of plausible values. Chosen beyond what the sensor or the robot can do, with a margin.
// Tests: test_values_beyond_the_sensor_range_are_implausible,
// test_nearly_unit_quaternion_is_normalised.
constexpr double kUnitNormTolerance = 0.05;  // |quaternion norm - 1|, above float rounding
constexpr double kMaxMagnitude = 1e4;  // in the unit of the field; beyond the values of every field
constexpr double kMaxAngularRate = 40.0;  // [rad/s] assumed full scale 2000 deg/s = 34.9, plus 15 %
constexpr double kMaxAcceleration = 200.0;  // [m/s^2] assumed full scale 16 g = 157, plus 27 %
constexpr double kJointMargin = 1.0;   // [rad] beyond the joint range; a folded calf rests outside
constexpr double kSpeedFactor = 2.0;   // times the motor's no-load speed
constexpr double kTorqueFactor = 3.0;  // times the motor's largest torque

// Checks one field after the other and keeps the worst status. The comparisons are written so that
// NaN fails.
struct FieldCheck {
  Status status = Status::kOk;
  Status sensor = Status::kOk;        // names the sensor of the first implausible field
  Status field_sensor = Status::kOk;  // names the sensor of the next fields
  void operator()(double value, double lower, double upper) noexcept {
    if (!(std::abs(value) <= kMaxMagnitude)) {
      status = Status::kNonFinite;
    } else if (!(value >= lower && value <= upper) && status == Status::kOk) {
      status = Status::kImplausible;
      sensor = field_sensor;
    }
  }
  void operator()(double value, double size) noexcept { (*this)(value, -size, size); }
};

FieldCheck check_fields(const LowState& state, const RobotConfig& config) noexcept {
  // Packed fields are not aligned: copy them before they are indexed.
  const std::array<float, 4> quaternion = state.imu.quaternion;
  const std::array<float, 3> gyroscope = state.imu.gyroscope;
  const std::array<float, 3> accelerometer = state.imu.accelerometer;
  FieldCheck check;
  for (const float value : quaternion) check(value, kMaxMagnitude);
  check.field_sensor = Status::kWrongGyroscope;
  for (const float value : gyroscope) check(value, kMaxAngularRate);
  check.field_sensor = Status::kWrongAccelerometer;
  for (const float value : accelerometer) check(value, kMaxAcceleration);
  for (int i = 0; i < kMotors; ++i) {
    const MotorState& motor = state.motorState[i];
    check.field_sensor = Status::kWrongJointAngles;
    check(motor.q, config.q_lower[i] - kJointMargin, config.q_upper[i] + kJointMargin);
    check.field_sensor = Status::kWrongJointVelocities;
    check(motor.dq, kSpeedFactor * config.no_load_speed[i]);
    check.field_sensor = Status::kWrongJointTorques;
    check(motor.tauEst, kTorqueFactor * config.tau_max[i]);
  }
  return check;
}

}  // namespace

Status check_low_state(const LowState& state, const RobotConfig& config) noexcept {
  return check_fields(state, config).status;
}

Status implausible_sensor(const LowState& state, const RobotConfig& config) noexcept {
  return check_fields(state, config).sensor;
}

bool has_unit_quaternion(const IMU& imu) noexcept {
  const std::array<float, 4> q = imu.quaternion;  // packed: not aligned
  return std::abs(std::hypot(std::hypot(q[0], q[1]), std::hypot(q[2], q[3])) - 1.0) <=
         kUnitNormTolerance;
}

}  // namespace surefoot
