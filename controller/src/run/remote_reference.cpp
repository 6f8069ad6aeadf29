// SPDX-License-Identifier: BSD-3-Clause
#include "run/remote_reference.hpp"

#include <cmath>

namespace surefoot {

namespace {

// Changes of the body pose at full deflection of a stick, or while a button is pressed. Chosen
// large enough for an operator to see; ReachCheck limits the pose on every robot.
constexpr double kForward = 0.04, kSideways = 0.03, kHeight = 0.03;  // [m]
constexpr double kRoll = 0.15, kPitch = 0.15, kYaw = 0.2;            // [rad]
// Dead zone, as a share of full deflection. Chosen larger than the offset of a released stick.
constexpr float kDeadZone = 0.05F;

double beyond_dead_zone(float stick) noexcept { return std::abs(stick) > kDeadZone ? stick : 0.0; }

}  // namespace

BodyReference remote_reference(const WirelessRemote& remote) noexcept {
  const auto button_axis = [&](Button plus, Button minus) {
    return (remote.pressed(plus) ? 1.0 : 0.0) - (remote.pressed(minus) ? 1.0 : 0.0);
  };
  BodyReference r;
  r.x = kForward * beyond_dead_zone(remote.ly);
  r.y = -kSideways * beyond_dead_zone(remote.lx);
  r.pitch = kPitch * beyond_dead_zone(remote.ry);
  r.yaw = -kYaw * beyond_dead_zone(remote.rx);
  r.height = kHeight * button_axis(Button::kUp, Button::kDown);
  r.roll = kRoll * button_axis(Button::kRight, Button::kLeft);
  return r;
}

}  // namespace surefoot
