// SPDX-License-Identifier: BSD-3-Clause
#include "run/remote_reference.hpp"

#include <cmath>

#include "gait/gait_size.hpp"

namespace surefoot {

namespace {

// Changes of the body pose at full deflection of a stick, or while a button is pressed. Chosen
// large enough for an operator to see; ReachCheck limits the pose on every robot.
constexpr double kForward = 0.04, kSideways = 0.03, kHeight = 0.03;  // [m]
constexpr double kRoll = 0.15, kPitch = 0.15, kYaw = 0.2;            // [rad]
// Dead zone, as a share of full deflection. Chosen larger than the offset of a released stick.
constexpr float kDeadZone = 0.05F;

// Velocities at full deflection. Chosen: a brisk walk, below the gains walk_speed_forward,
// _sideways and walk_turn_speed of all robots. At h = 0.3 m: 0.6 m/s, 0.3 m/s, 1.1 rad/s.
constexpr double kForwardSpeed = 0.35, kSidewaysSpeed = 0.18;  // [sqrt(g h)]
constexpr double kTurnSpeed = 0.2;                             // [sqrt(g/h)]
// Dead zone of velocities. Chosen larger than kDeadZone: a robot must not creep.
constexpr double kVelocityDeadZone = 0.1;

// Return 0 within the dead zone, and beyond it a value that grows from 0 to +-1.
double scaled_stick(float stick) noexcept {
  const double beyond = std::abs(static_cast<double>(stick)) - kVelocityDeadZone;
  return beyond > 0.0 ? std::copysign(beyond / (1.0 - kVelocityDeadZone), stick) : 0.0;
}

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

StickSpeeds::StickSpeeds(const Robot& robot) {
  const GaitSize size(robot);
  full = {kForwardSpeed * size.speed, kSidewaysSpeed * size.speed, kTurnSpeed / size.time};
}

WalkVelocity remote_velocity(const WirelessRemote& remote, const StickSpeeds& speeds) noexcept {
  return {speeds.full.vx * scaled_stick(remote.ly), -speeds.full.vy * scaled_stick(remote.lx),
          -speeds.full.yaw_rate * scaled_stick(remote.rx)};
}

}  // namespace surefoot
