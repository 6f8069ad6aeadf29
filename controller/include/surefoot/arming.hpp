// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>

#include "surefoot/robot_config.hpp"

namespace surefoot {

/// Checks that must pass before the supervisor applies torques to a lying robot.
enum class ArmingCheckId : int {
  kLink = 0,       ///< LowStates arrive, this tick has a new one, and fewer than 1 % are missing
  kMotorMode,      ///< all twelve motors report servo mode
  kTemperature,    ///< all twelve motors are below SupervisorOptions::temperature_warning
  kQuaternion,     ///< the IMU quaternion has unit length
  kGyroscope,      ///< the body does not rotate
  kAccelerometer,  ///< the specific force has the magnitude of gravity
  kAttitude,       ///< quaternion and accelerometer agree about the vertical; not about heading
  kTilt,           ///< the body is nearly level
  kJoints,         ///< all joints keep SupervisorOptions::joint_margin from their limits
  kMotorOrder,     ///< every joint angle fits the range of its own motor; else motors are swapped
  kFootForce,      ///< footForceEst adds up to the weight; only if standing and footForceEst works
  kProgram,        ///< the torques that hold the robot during a rise are below their limits
  kFault,          ///< no active fault prevents a rise
  kConflict        ///< no other program commands the robot, see Supervisor::report_conflict()
};
constexpr int kArmingChecks = 14;  ///< number of arming checks
/// Return the name of a check, such as "motor_mode". Real-time: yes.
const char* to_string(ArmingCheckId id) noexcept;

/// Result of one arming check.
struct ArmingCheck {
  bool applies = true;    ///< false: the check does not apply now and counts as passed
  bool passed = false;    ///< true: the value is within the limit
  double value = 0.0;     ///< worst value found; describe() gives its unit
  double limit = 0.0;     ///< limit that the value is compared with, in the same unit
  int motor = -1;         ///< SDK number of the motor with the worst value, or -1
  int swapped_with = -1;  ///< SDK number of the second motor if `motor` seems swapped; else -1
};

/// Results of all arming checks, in the order of ArmingCheckId.
struct ArmingReport {
  std::array<ArmingCheck, kArmingChecks> checks;  ///< indexed by ArmingCheckId
  double passed_for = 0.0;  ///< [s] time for which all checks have passed without interruption
  bool ready = false;       ///< true: passed_for has reached SupervisorOptions::arming_time

  /// Return the result of one check. Real-time: yes.
  const ArmingCheck& operator[](ArmingCheckId id) const noexcept {
    return checks[static_cast<int>(id)];
  }
};

/// Describe one check in a sentence, such as "temperature: RR_2 at 71 deg C, expected below 60".
/// Real-time: no.
std::string describe(ArmingCheckId id, const ArmingCheck& check, const RobotConfig& config);

/// Describe all failed checks, one sentence per line; empty if no check failed. Real-time: no.
std::string describe_failures(const ArmingReport& report, const RobotConfig& config);

}  // namespace surefoot
