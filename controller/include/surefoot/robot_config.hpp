// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>

#include "surefoot/gains.hpp"
#include "surefoot/math.hpp"

namespace surefoot {

/// Properties of a robot that its kinematic and inertial model does not have. Arrays of twelve are
/// in SDK motor order (FR FL RR RL; hip, thigh, calf), arrays of four in leg order.
struct RobotConfig {
  std::string name;                              ///< name of the robot, one word
  std::array<std::string, kMotors> joint_names;  ///< names of the joints in the model
  std::array<std::string, kLegs> foot_frames;    ///< names of the foot frames in the model
  double foot_radius = 0.0;  ///< [m] radius of the foot, a sphere about the origin of its frame

  Vector3 p_base_imu = Vector3::Zero();                  ///< [m] IMU origin in the base frame
  Eigen::Vector4d quat_base_imu = {1.0, 0.0, 0.0, 0.0};  ///< quaternion w x y z, IMU to base axes

  Vector12 q_lower = Vector12::Zero();  ///< [rad] lower limits: SDK and URDF, the narrower
  Vector12 q_upper = Vector12::Zero();  ///< [rad] upper limits: SDK and URDF, the narrower
  double hip_inward = 3.2;  ///< [rad] largest inward angle of every hip, > 0, see motion_range()
  Vector12 dq_max = Vector12::Zero();         ///< [rad/s] velocity limits
  Vector12 tau_max = Vector12::Zero();        ///< [N.m] torque limits up to corner_speed
  Vector12 corner_speed = Vector12::Zero();   ///< [rad/s] the torque limit falls from here on
  Vector12 no_load_speed = Vector12::Zero();  ///< [rad/s] the torque limit is zero from here on
  Vector12 armature = Vector12::Zero();       ///< [kg.m^2] rotor inertia times squared gear ratio
  Vector12 q_standing = Vector12::Zero();     ///< [rad] joint angles of the standing pose

  double friction = 0.6;  ///< coefficient between foot and ground that the controller assumes
  Gains gains;            ///< default gains of this robot

  /// Throw surefoot::Error if a field is invalid; the message names the field, what was got and
  /// what was expected.
  void validate() const;
};

/// Range of a joint angle [rad].
struct JointRange {
  double lower,  ///< [rad] smallest angle
      upper;     ///< [rad] largest angle
};

/// Compute the range within which QP and body reference keep motor `i`, 0 .. 11.
///
/// The range is q_lower .. q_upper; for a hip it ends at hip_inward on the inward side. Beyond
/// hip_inward the trunk rests on the thigh, and the dynamics do not model this contact. Arming
/// checks and protections use q_lower and q_upper instead, because an external force may push a hip
/// beyond hip_inward. Real-time: yes.
JointRange motion_range(const RobotConfig& config, int i) noexcept;

/// Compute the largest torque [N.m] of motor `i`, 0 .. 11, in the direction of `sign` at joint
/// velocity `dq` [rad/s]. The result is not negative.
///
/// While torque and velocity have the same sign, the limit is tau_max up to corner_speed, then
/// falls linearly to zero at no_load_speed. A braking motor keeps tau_max. Real-time: yes.
double motor_torque_limit(const RobotConfig& config, int i, double dq, double sign) noexcept;

}  // namespace surefoot
