// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace surefoot {

/// Velocity of a walking robot in its heading frame: x forward, y to the left, z up.
struct WalkVelocity {
  double vx = 0.0;        ///< [m/s] centre of mass, forward
  double vy = 0.0;        ///< [m/s] centre of mass, to the left
  double yaw_rate = 0.0;  ///< [rad/s] to the left
};

/// Limit to which a commanded velocity was clamped.
enum class WalkLimit {
  kNone,         ///< the command was not clamped
  kForward,      ///< vx: gains walk_speed_forward and walk_speed_backward; walk: walk_gait_speed
  kSideways,     ///< vy: gain walk_speed_sideways; walk: walk_gait_speed
  kTurn,         ///< yaw_rate: gain walk_turn_speed; walk: walk_gait_turn_speed
  kCombination,  ///< all: the sum of the shares of the limits, or the acceleration in a curve
  kPower,        ///< all: the power that ControllerOptions::power_limit allows
  kNotFinite     ///< the command has a NaN or an infinity; the previous one stays in force
};
/// Return the name of a limit, such as "forward". Real-time: yes.
const char* to_string(WalkLimit limit) noexcept;

/// What a WalkController does.
enum class Gait {
  kAuto,  ///< stand at velocity 0, trot otherwise
  kTrot,  ///< trot, also at velocity 0
  kWalk   ///< stand at velocity 0, walk otherwise: one foot steps at a time, three feet are down
};
/// Return the name of a gait, such as "trot". Real-time: yes.
const char* to_string(Gait gait) noexcept;

}  // namespace surefoot
