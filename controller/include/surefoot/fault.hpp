// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace surefoot {

/// Faults of a supervised robot and of the link to it. fault_table() says how each is detected and
/// what the supervisor does about it.
enum class FaultId : int {
  kNone = 0,          ///< no fault
  kStop,              ///< Supervisor::stop() was called
  kButton,            ///< button B on the remote was pressed
  kStateNotFinite,    ///< a field that is read is NaN or infinite
  kStateImplausible,  ///< a field that is read is beyond what the robot can do or measure
  kStaleTick,         ///< LowState::tick does not advance, goes backwards or jumps ahead
  kFrozen,            ///< tick advances, but IMU and joints repeat the same values
  kLoss,              ///< too many LowStates are missing
  kJointJump,         ///< a joint angle jumps by more than its velocity explains
  kEncoder,           ///< the encoders of a leg have stopped while the leg moves
  kClock,             ///< the robot's clock runs faster than its joints move
  kQuaternion,     ///< the IMU quaternion is not of unit length, or contradicts gyroscope and legs
  kAttitude,       ///< attitude and gyroscope contradict each other, or there is no attitude
  kGyroscope,      ///< the gyroscope is zero, constant, saturated or contradicted
  kAccelerometer,  ///< the accelerometer is zero, constant, saturated or contradicted
  kFootForce,      ///< a foot force sensor is stuck, saturated or contradicted
  kSlip,           ///< a stance foot slips
  kLifted,         ///< no foot carries load
  kPayload,        ///< the payload is above SupervisorOptions::payload_limit
  kTilt,           ///< the body is tilted too far, or about to be
  kMotorMode,      ///< a motor left servo mode
  kMotorWeak,      ///< the torque of a motor does not follow its command
  kLegLost,        ///< motors of one leg have failed; the robot stands on the other three legs
  kOverridden,     ///< motors of several legs do not follow: another source commands them too
  kWiring,         ///< legs or motors are swapped or turn the wrong way
  kWrongRobot,     ///< the robot does not fit the model
  kTemperature,    ///< a motor is hot: first its torque limit falls, then the robot sits down
  kJointStop,      ///< a joint is beyond its stop
  kPower,          ///< the power protection tripped
  kTorqueRate,     ///< the torque rate limiter held back the controller's torques
  kProgram,        ///< the first solve of a tick failed, see StandController::fallback_level()
  kController,     ///< the StandController damps, see StandController::fault()
  kHanging,        ///< after the rise the legs carry too little of the weight
  kBattery,        ///< the charge is below SupervisorOptions::battery_low
  kOperator,       ///< no heartbeat() within SupervisorOptions::operator_timeout
  kLink            ///< Supervisor::report_link_lost(): no LowStates, or the robot restarted
};
constexpr int kFaults = static_cast<int>(FaultId::kLink) + 1;  ///< number of ids, with kNone
/// Return the name of a fault, such as "motor_weak". Real-time: yes.
const char* to_string(FaultId id) noexcept;

/// What the supervisor does about a fault.
enum class FaultReaction : int {
  kNone = 0,  ///< nothing: there is no fault
  kWatch,     ///< the fault is reported and counted; the robot continues
  kDegrade,   ///< the robot continues with the remaining sensors, contacts or legs
  /// The robot sits down and does not rise while the fault lasts. A robot that walks stops on four
  /// feet first, within 1.5 s. If only a standing robot can
  /// detect the fault (payload, the estimator's verdict on the gyroscope), the robot does not rise
  /// again until arm() is called.
  kSit,
  kDamp  ///< the motors damp until arm()
};
/// Return the name of a reaction, such as "degrade". Real-time: yes.
const char* to_string(FaultReaction reaction) noexcept;

/// One row of fault_table().
struct FaultInfo {
  FaultId id = FaultId::kNone;                    ///< the fault
  FaultReaction reaction = FaultReaction::kNone;  ///< what the supervisor does about the fault
  double detection_time = 0.0;  ///< [s] longest time from the onset of the fault to the reaction
  std::string_view cleared_by;  ///< what ends the reaction after the fault has ended
  std::string_view meaning;     ///< how the fault is detected and how the supervisor reacts
  /// What differs while the feet step (Reference::stepping); empty: nothing.
  std::string_view while_stepping = {};
  /// [s] Longest time from the onset to the reaction while the feet step; 0: detection_time.
  double stepping_detection_time = 0.0;
  /// True: a robot that walks stops and stands, and kWalk is refused while the fault is active. So
  /// do all faults with the reaction kSit.
  bool stops_walking = false;
};
/// Return a row for every fault but kNone, in the order of FaultId. Real-time: yes.
const std::array<FaultInfo, kFaults - 1>& fault_table() noexcept;
/// Return the row of one fault; an empty row for kNone. Real-time: yes.
FaultInfo fault_info(FaultId id) noexcept;

/// Active and past faults of a Supervisor, indexed by FaultId. Plain data.
struct FaultReport {
  std::array<bool, kFaults> active{};          ///< true while the fault lasts
  std::array<std::uint32_t, kFaults> count{};  ///< number of times that each fault has begun
  std::array<int, kFaults> motor{};  ///< SDK number of the motor that last had the fault, or -1
  FaultId last = FaultId::kNone;     ///< fault that began last

  /// Return whether a fault is active. Real-time: yes.
  bool has(FaultId id) const noexcept { return active[static_cast<int>(id)]; }
  /// Return the first active fault with this reaction, in the order of FaultId, but never `except`.
  /// Return kNone if no such fault is active. Real-time: yes.
  FaultId first_active(FaultReaction reaction, FaultId except = FaultId::kNone) const noexcept;
  /// Return the first active fault with FaultInfo::stops_walking, or kNone. Real-time: yes.
  FaultId stops_walking() const noexcept;
};

}  // namespace surefoot
