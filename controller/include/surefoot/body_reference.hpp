// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/math.hpp"

namespace surefoot {

/// Pose of the body relative to the latched pose; all zero is the latched pose.
///
/// Displacement of the base origin along the axes of the support frame (x forward, y left, z out of
/// the ground), and orientation in that frame: R = Rz(yaw) Ry(pitch) Rx(roll) R_latched.
struct BodyReference {
  double x = 0.0;       ///< [m] displacement forward
  double y = 0.0;       ///< [m] displacement to the left
  double height = 0.0;  ///< [m] displacement along the ground normal, out of the ground
  double roll = 0.0;    ///< [rad] rotation about x, forward
  double pitch = 0.0;   ///< [rad] rotation about y, to the left
  double yaw = 0.0;     ///< [rad] rotation about z, the ground normal
};

/// Limit that stops the body reference before its target.
enum class ReachLimit {
  kNone,     ///< no limit: the reference is at the target or moves towards it
  kJoint,    ///< a joint would come closer than reach_joint_margin to an end of motion_range()
  kSupport,  ///< the centre of mass would come closer than reach_support_margin to a support edge
  kFootHeight,   ///< a foot would be less than reach_foot_depth below its hip axis
  kUnreachable,  ///< a leg is too short to reach its foot position
  kNotFinite     ///< the target has a NaN or an infinity; the previous target stays in force
};
/// Return the name of a limit, such as "foot_height". Real-time: yes.
const char* to_string(ReachLimit limit) noexcept;

/// Limit that stops the body reference, and the motor to which the limit belongs.
struct ReachStatus {
  ReachLimit limit = ReachLimit::kNone;  ///< limit that stops the reference, or kNone
  /// SDK number of the joint (kJoint) or of the hip of the leg (kFootHeight); -1 for other limits.
  int motor = -1;
};

}  // namespace surefoot
