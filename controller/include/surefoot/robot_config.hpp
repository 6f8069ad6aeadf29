// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>

#include "surefoot/gains.hpp"
#include "surefoot/math.hpp"

namespace surefoot {

/// What a robot is beyond its kinematics and masses. Twelve values run in SDK motor order
/// (FR FL RR RL; hip, thigh, calf), four in leg order.
struct RobotConfig {
  std::string name;
  std::array<std::string, kMotors> joint_names;
  std::array<std::string, kLegs> foot_frames;
  double foot_radius = 0.0;  ///< [m] the contact point lies this far from the foot frame

  Vector3 p_base_imu = Vector3::Zero();                  ///< [m] IMU origin in the base frame
  Eigen::Vector4d quat_base_imu = {1.0, 0.0, 0.0, 0.0};  ///< w x y z; maps IMU axes to base axes

  Vector12 q_lower = Vector12::Zero();        ///< [rad] SDK and URDF limits, intersected
  Vector12 q_upper = Vector12::Zero();        ///< [rad]
  double hip_inward = 3.2;                    ///< [rad] that hips may turn legs under the trunk
  Vector12 dq_max = Vector12::Zero();         ///< [rad/s]
  Vector12 tau_max = Vector12::Zero();        ///< [N.m] up to corner_speed
  Vector12 corner_speed = Vector12::Zero();   ///< [rad/s] torque starts to fall here ...
  Vector12 no_load_speed = Vector12::Zero();  ///< [rad/s] ... and has vanished here
  Vector12 armature = Vector12::Zero();       ///< [kg.m^2] rotor inertia times gear ratio squared
  Vector12 q_standing = Vector12::Zero();     ///< [rad]

  double friction = 0.6;  ///< coefficient that the controller assumes between foot and ground
  Gains gains;            ///< this robot's defaults

  /// Throw surefoot::Error naming the field, what was got and what is expected.
  void validate() const;
};

/// Range of a joint [rad].
struct JointRange {
  double lower, upper;
};

/// Where the program takes motor `i`, and a body reference: q_lower .. q_upper, a hip no further
/// inward than hip_inward. Beyond it the trunk bears on a thigh that the dynamics take for free.
/// What judges angles or protects has q_lower and q_upper: a joint may well be pushed there.
/// Real-time: yes.
JointRange motion_range(const RobotConfig& config, int i) noexcept;

/// Greatest torque of motor `i` in the direction of `sign` at joint velocity `dq`.
///
/// Constant to corner_speed, then linear to zero at no_load_speed while torque and velocity have
/// one sign; a braking motor keeps its full torque. Real-time: yes.
double motor_torque_limit(const RobotConfig& config, int i, double dq, double sign) noexcept;

}  // namespace surefoot
