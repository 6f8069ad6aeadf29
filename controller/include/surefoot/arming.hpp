// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>

#include "surefoot/robot_config.hpp"

namespace surefoot {

/// What must be right with a robot before its motors may get torques.
enum class ArmingCheckId : int {
  kLink = 0,       ///< LowStates come, and less than 1 % of them is missing
  kMotorMode,      ///< all twelve motors report servo mode
  kTemperature,    ///< all twelve motors are below the warning temperature
  kQuaternion,     ///< the IMU's quaternion is of unit length
  kGyroscope,      ///< the body does not turn
  kAccelerometer,  ///< what it feels is gravity
  kAttitude,       ///< the quaternion's vertical is the one that is felt; level, any heading fits
  kTilt,           ///< the body is near level
  kJoints,         ///< joints are inside this robot's limits
  kMotorOrder,     ///< angles fit the motors they are reported for
  kFootForce,      ///< feet bear the robot's weight; only where it stands on living sensors
  kProgram,        ///< getting up and standing is within this robot's torques
  kFault           ///< no fault is present that a robot lies down for
};
constexpr int kArmingChecks = 13;
const char* to_string(ArmingCheckId id) noexcept;

/// One check: what was found, and what is expected.
struct ArmingCheck {
  bool applies = true;  ///< false: nothing to judge here; it then counts as passed
  bool passed = false;
  double value = 0.0;     ///< the worst that was found; unit in describe()
  double limit = 0.0;     ///< what it was held against
  int motor = -1;         ///< SDK number of the motor that it was found at, or -1
  int swapped_with = -1;  ///< motor that it seems to have been swapped with, or -1
};

/// All checks, in the order of ArmingCheckId.
struct ArmingReport {
  std::array<ArmingCheck, kArmingChecks> checks;
  double passed_for = 0.0;  ///< [s] that all have passed without a break
  bool ready = false;       ///< have they for the time that arming asks for?

  const ArmingCheck& operator[](ArmingCheckId id) const noexcept {
    return checks[static_cast<int>(id)];
  }
};

/// One check in a sentence, such as "temperature: RR_2 at 71 deg C, expected below 60". Not for
/// the tick.
std::string describe(ArmingCheckId id, const ArmingCheck& check, const RobotConfig& config);

/// The sentences of all checks that failed, one a line; empty if none has. Not for the tick.
std::string describe_failures(const ArmingReport& report, const RobotConfig& config);

}  // namespace surefoot
