// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace surefoot {

/// State of a supervised robot.
enum class Mode : int {
  kPassive = 0,  ///< the motors damp; the first mode, and the one after sitting down
  kRise,         ///< the robot rises from lying to standing
  kStand,        ///< the StandController is in control
  kSit,          ///< the robot sits down; also the way to abort a rise
  kDamping       ///< the motors damp, latched: only arm() leaves this mode
};
/// Return the name of a mode, such as "rise". Real-time: yes.
const char* to_string(Mode mode) noexcept;

/// State of the robot when the supervisor takes it over.
enum class Start : int {
  kLying = 0,  ///< the motors damp: arming checks, arm(), then a rise
  /// The robot already stands under another controller and would sink during any pause. The
  /// supervisor takes it over with the first valid LowState, without arming checks. After latched
  /// damping, arm() takes over the pose in which it finds the robot, again without checks.
  kStanding
};
/// Return "lying" or "standing". Real-time: yes.
const char* to_string(Start start) noexcept;

/// Stage of a rise. In all stages but kUp the body lies on the ground.
enum class RiseStage : int {
  kHoldLegs = 0,  ///< the legs hold their own weight where they are
  kFold,          ///< the legs fold beside the body
  kWeigh,         ///< the hips turn outward: their torques must fit the weight of the legs
  kPress,         ///< the rear legs press on the ground: the nose must go down
  kUp             ///< from folded legs over a crouch to the standing pose, or back down
};
/// Return the name of a stage, such as "weigh". Real-time: yes.
const char* to_string(RiseStage stage) noexcept;

/// Answer to a request. For any status but kAccepted the request has no effect.
enum class RequestStatus : int {
  kAccepted = 0,  ///< the next update() handles the request
  kNoState,       ///< no valid LowState arrives, or none has arrived yet
  kNotArmed,      ///< the robot is not armed: call arm() first
  kNotReady,    ///< an arming check fails or passed too briefly, see arming(); or a fault is active
  kLatched,     ///< damping is latched: call arm() first
  kOutOfOrder,  ///< not possible from this mode, see Supervisor::request()
  kBusy         ///< another request or a stop is pending, or torques fade between two modes
};
/// Return the name of a status, such as "not_ready". Real-time: yes.
const char* to_string(RequestStatus status) noexcept;

}  // namespace surefoot
