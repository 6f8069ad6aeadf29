// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace surefoot {

/// What the robot is doing.
enum class Mode : int {
  kPassive = 0,  ///< the motors damp; where it begins, and where sitting down ends
  kRise,         ///< on its way up from lying
  kStand,        ///< a StandController at work
  kSit,          ///< on its way down; also how a rise is aborted
  kDamping       ///< the motors damp, latched: only arm() leads out
};
const char* to_string(Mode mode) noexcept;

/// How the robot is when it is taken on.
enum class Start : int {
  kLying = 0,  ///< motors damp; arming checks, arm(), then a rise
  /// It stands already, held by something else, and would sink in any pause: the first good
  /// LowState is taken over, without arming checks. So is, after latched damping, the pose that
  /// arm() finds.
  kStanding
};
const char* to_string(Start start) noexcept;

/// How far a rise is. In all but the last the body lies on the ground.
enum class RiseStage : int {
  kHoldLegs = 0,  ///< legs hold themselves up where they are
  kFold,          ///< they fold beside the body
  kWeigh,         ///< hips outward: do the legs weigh what they should?
  kPress,         ///< the rear pair presses: does the nose go down?
  kUp             ///< over a crouch to the standing pose, or back down
};
const char* to_string(RiseStage stage) noexcept;

/// What became of a request. Anything but kAccepted: nothing moves for it.
enum class RequestStatus : int {
  kAccepted = 0,  ///< the next update() takes it up
  kNoState,       ///< no valid LowState comes, or none has yet
  kNotArmed,      ///< arm() first
  kNotReady,      ///< an arming check fails, or has not passed for long enough: arming()
  kLatched,       ///< damping is latched: arm() first
  kOutOfOrder,    ///< not from this mode: rise from passive, sit from rise and stand, ...
  kBusy           ///< another request or a stop waits, or torques are on their way to a mode
};
const char* to_string(RequestStatus status) noexcept;

}  // namespace surefoot
