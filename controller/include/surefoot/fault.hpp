// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace surefoot {

/// What can be wrong with a robot that is supervised, or with the way it is talked to.
enum class FaultId : int {
  kNone = 0,
  kStop,              ///< Supervisor::stop()
  kButton,            ///< B on the remote
  kStateNotFinite,    ///< a NaN or an infinity in a field that is used
  kStateImplausible,  ///< a used field is beyond what the robot can do or measure
  kStaleTick,         ///< tick stands still, runs backwards or leaps
  kFrozen,            ///< tick advances, the sensors repeat themselves byte by byte
  kLoss,              ///< too many reports are missing
  kJointJump,         ///< a joint's angle jumps against its own speed
  kEncoder,           ///< a leg's encoders have stopped while it moves
  kClock,             ///< the robot's clock goes faster than its joints
  kQuaternion,        ///< no unit length, or it contradicts gyroscope and legs
  kAttitude,          ///< attitude and gyroscope jump against each other, or there is none
  kGyroscope,         ///< zero, constant, saturated or contradicted
  kAccelerometer,     ///< zero, constant, saturated or contradicted
  kFootForce,         ///< a foot's sensor is stuck, saturated or contradicted
  kSlip,              ///< a standing foot slips
  kLifted,            ///< no foot bears anything
  kPayload,           ///< the robot bears more than it is allowed to
  kTilt,              ///< the body is tilted too far, or about to be
  kMotorMode,         ///< a motor left servo mode
  kMotorWeak,         ///< a motor does not give the torque it is told
  kLegLost,           ///< one leg's motors do not, and the robot stands on the other three
  kOverridden,        ///< several legs do not: somebody else commands the robot too
  kWiring,            ///< legs or motors are not where they are taken to be
  kWrongRobot,        ///< it is another robot than it is taken for
  kTemperature,       ///< a motor is hot: its torque is derated, then the robot sits down
  kJointStop,         ///< a joint is beyond its stop
  kPower,             ///< the power protection tripped
  kTorqueRate,        ///< torques were asked to jump
  kProgram,           ///< no solution at once: stand_controller().fallback_level()
  kController,        ///< the StandController gave up: stand_controller().fault()
  kHanging,           ///< on its way up the legs bear nothing
  kBattery,           ///< low
  kOperator,          ///< no heartbeat from the operator
  kLink               ///< Supervisor::report_link_lost(): the robot is not heard, or began anew
};
constexpr int kFaults = static_cast<int>(FaultId::kLink) + 1;  ///< kNone included
const char* to_string(FaultId id) noexcept;

/// What is done about a fault.
enum class FaultReaction : int {
  kNone = 0,
  kWatch,    ///< it is said and counted
  kDegrade,  ///< the robot goes on with what is left
  /// The robot sits down, and does not get up while the fault lasts; where only one that stands can
  /// tell (payload, an estimator's gyroscope), not before arm().
  kSit,
  kDamp  ///< the motors brake, latched until arm()
};
const char* to_string(FaultReaction reaction) noexcept;

/// One row of fault_table().
struct FaultInfo {
  FaultId id = FaultId::kNone;
  FaultReaction reaction = FaultReaction::kNone;
  double detection_time = 0.0;  ///< [s] from its begin to the reaction, at most
  std::string_view cleared_by;  ///< what ends the reaction, once it is no longer seen
  std::string_view meaning;     ///< how it is seen and what is done, in a sentence
};
/// Every fault but kNone, in the order of FaultId.
const std::array<FaultInfo, kFaults - 1>& fault_table() noexcept;
/// The row of one fault; of kNone an empty one. Real-time: yes.
FaultInfo fault_info(FaultId id) noexcept;

/// Which faults there are, and have been. Plain data.
struct FaultReport {
  std::array<bool, kFaults> active{};
  std::array<std::uint32_t, kFaults> count{};  ///< how often each has begun
  std::array<int, kFaults> motor{};            ///< SDK number it was last seen at, or -1
  FaultId last = FaultId::kNone;               ///< that began last

  bool has(FaultId id) const noexcept { return active[static_cast<int>(id)]; }
  /// The first fault there is with a reaction, but for one, or kNone. Real-time: yes.
  FaultId first_active(FaultReaction reaction, FaultId except = FaultId::kNone) const noexcept;
};

}  // namespace surefoot
