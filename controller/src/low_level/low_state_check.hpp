// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/robot_config.hpp"
#include "surefoot/types.hpp"

namespace surefoot {

/// Check every floating-point field that the controller uses. Real-time: yes.
///
/// @return kNonFinite if a value is NaN, infinite or larger than 1e4 in its unit; kImplausible if a
/// value is larger than the sensor or the robot allows: angular rates over 40 rad/s, accelerations
/// over 200 m/s^2, joints more than 1 rad outside their range, joint velocities over twice the
/// motor's no-load speed, torques over three times its largest torque; else kOk.
Status check_low_state(const LowState& state, const RobotConfig& config) noexcept;

/// Return the status that names the sensor of the first implausible field, such as
/// kWrongJointAngles; kOk if no field is implausible. Real-time: yes.
Status implausible_sensor(const LowState& state, const RobotConfig& config) noexcept;

/// Return whether the norm of the IMU quaternion is within 5 % of 1. Real-time: yes.
bool has_unit_quaternion(const IMU& imu) noexcept;

}  // namespace surefoot
