// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/robot_config.hpp"
#include "surefoot/types.hpp"

namespace surefoot {

/// Judge every floating-point field that the controller uses. Real-time: yes.
///
/// @return kNonFinite for NaN, infinities and anything beyond 1e4 in any unit; kImplausible for
/// what no such sensor or robot can say (rates over 40 rad/s, accelerations over 20 g, joints far
/// outside their range or twice as fast as their motor); else kOk.
Status check_low_state(const LowState& state, const RobotConfig& config) noexcept;

/// Is the IMU's quaternion one, within 5 % of unit length? Real-time: yes.
bool has_unit_quaternion(const IMU& imu) noexcept;

}  // namespace surefoot
