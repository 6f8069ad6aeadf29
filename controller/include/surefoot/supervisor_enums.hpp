// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace surefoot {

/// State of a supervised robot.
enum class Mode : int {
  kPassive = 0,  ///< the motors damp; this is the first mode, and the mode after sitting down
  kRise,         ///< the robot rises from lying to standing
  kStand,        ///< the robot stands, and steps only to keep its balance
  kWalk,         ///< the robot follows Supervisor::set_velocity(); at velocity 0 it stands
  kSit,          ///< the robot sits down; request this mode also to abort a rise
  kDamping       ///< the motors damp until arm(), the only way to leave this mode
};
/// Return the name of a mode, such as "rise". Real-time: yes.
const char* to_string(Mode mode) noexcept;

/// State of the robot when the supervisor takes it over.
enum class Start : int {
  /// The robot lies and its motors damp. It must pass the arming checks, then arm() must be called,
  /// then the robot may rise.
  kLying = 0,
  /// The robot already stands under another controller, and would sink if torques paused. The
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
  /// The hips turn outward. This is a check: hip torques that do not match the weight of the legs
  /// are the fault kWiring or kWrongRobot.
  kWeigh,
  /// The rear legs press on the ground. This is a check: if the front of the trunk does not go
  /// down, the fault is kWiring.
  kPress,
  kUp  ///< the legs move from the folded pose through a crouch to the standing pose, or back
};
/// Return the name of a stage, such as "weigh". Real-time: yes.
const char* to_string(RiseStage stage) noexcept;

/// Answer to a request. For any status but kAccepted the request has no effect.
enum class RequestStatus : int {
  kAccepted = 0,  ///< the next update() handles the request
  kNoState,       ///< no valid LowState has arrived, or they no longer arrive
  kNotArmed,      ///< the robot is not armed: call arm() first
  /// An arming check fails, or has not passed for SupervisorOptions::arming_time yet, or a fault
  /// keeps the robot down; see Supervisor::arming(). For kWalk: a fault that makes a walking robot
  /// stop is active; see Supervisor::faults().
  kNotReady,
  kLatched,     ///< damping is latched: call arm() first
  kOutOfOrder,  ///< the present mode does not allow this request, see Supervisor::request()
  /// Another request or a stop is pending, torques fade between two modes, or the robot stops
  /// walking.
  kBusy,
  kCannotWalk  ///< the motors cannot carry the robot on two feet, see WalkController::can_walk()
};
/// Return the name of a status, such as "not_ready". Real-time: yes.
const char* to_string(RequestStatus status) noexcept;

}  // namespace surefoot
