// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/body_reference.hpp"
#include "surefoot/robot.hpp"
#include "surefoot/walk_velocity.hpp"
#include "surefoot/wireless_remote.hpp"

namespace surefoot {

/// Convert the remote's sticks and buttons to a body reference. The left stick shifts the body; the
/// right stick changes pitch and yaw. The buttons up and down change the height; the buttons left
/// and right change roll. With the remote at rest, the result is the latched pose. Real-time: yes.
BodyReference remote_reference(const WirelessRemote& remote) noexcept;

/// Velocities of a walking robot at full deflection of the sticks. They scale with the robot's
/// size.
struct StickSpeeds {
  explicit StickSpeeds(const Robot& robot);
  WalkVelocity full;
};

/// Convert the remote's sticks to a velocity: the left stick moves forward and sideways, the right
/// stick turns. It is 0 within the dead zone and begins at 0 at its edge. Real-time: yes.
WalkVelocity remote_velocity(const WirelessRemote& remote, const StickSpeeds& speeds) noexcept;

}  // namespace surefoot
