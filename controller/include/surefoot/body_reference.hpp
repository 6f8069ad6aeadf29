// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/math.hpp"

namespace surefoot {

/// Where the body is asked to be, from the pose that was latched: all zero is that pose.
///
/// Position of the base's origin along the axes of the support frame (forward, left, out of the
/// ground), orientation about them: R = Rz(yaw) Ry(pitch) Rx(roll) R_latched.
struct BodyReference {
  double x = 0.0;       ///< [m]
  double y = 0.0;       ///< [m]
  double height = 0.0;  ///< [m]
  double roll = 0.0;    ///< [rad]
  double pitch = 0.0;   ///< [rad]
  double yaw = 0.0;     ///< [rad]
};

/// What keeps the body from going where it is asked to.
enum class ReachLimit {
  kNone,         ///< nothing: it is there, or on its way
  kJoint,        ///< a joint would come within reach_joint_margin of its limit
  kSupport,      ///< the centre of mass would come within reach_support_margin of the edge
  kFootHeight,   ///< a foot would come within reach_foot_depth of the height of its hip axis
  kUnreachable,  ///< a leg is too short
  kNotFinite     ///< what was asked is not a number; the last request stands
};
const char* to_string(ReachLimit limit) noexcept;

/// A limit, and whose it is.
struct ReachStatus {
  ReachLimit limit = ReachLimit::kNone;
  int motor = -1;  ///< SDK motor: kJoint the joint's, kFootHeight the leg's hip
};

}  // namespace surefoot
