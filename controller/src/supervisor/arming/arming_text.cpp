// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cstdio>

#include "surefoot/arming.hpp"
#include "surefoot/fault.hpp"

namespace surefoot {

namespace {

constexpr std::array<const char*, kMotors> kMotorNames = {
    "FR_0", "FR_1", "FR_2", "FL_0", "FL_1", "FL_2", "RR_0", "RR_1", "RR_2", "RL_0", "RL_1", "RL_2"};

template <typename... Values>
std::string format(const char* pattern, Values... values) {
  char text[200];
  std::snprintf(text, sizeof(text), pattern, values...);
  return text;
}

std::string describe_order(const ArmingCheck& check, const RobotConfig& config) {
  if (check.motor < 0) return "every joint angle is in the range of its motor";
  const char* motor = kMotorNames[check.motor];
  if (check.swapped_with >= 0) {
    return format("%s and %s seem swapped", kMotorNames[std::min(check.motor, check.swapped_with)],
                  kMotorNames[std::max(check.motor, check.swapped_with)]);
  }
  return format(
      "%s is %.2f rad outside its range on a %s; check the robot and the order of its motors",
      motor, check.value, config.name.c_str());
}

std::string describe_value(ArmingCheckId id, const ArmingCheck& c, const RobotConfig& config) {
  const char* motor = c.motor >= 0 ? kMotorNames[c.motor] : "";
  switch (id) {
    case ArmingCheckId::kLink:
      return format("%.2g %% of the samples missing, expected below %.2g %% and a new sample",
                    100.0 * c.value, 100.0 * c.limit);
    case ArmingCheckId::kMotorMode:
      if (c.passed) return "all motors in servo mode";
      return format("%s in mode 0x%02X, expected servo mode 0x0A", motor, int(c.value));
    case ArmingCheckId::kTemperature:
      return format("%s at %.0f deg C, expected below %.0f", motor, c.value, c.limit);
    case ArmingCheckId::kQuaternion:
      return format("length differs from 1 by %.2g, expected below %.2g", c.value, c.limit);
    case ArmingCheckId::kGyroscope:
      return format("%.3f rad/s, expected below %.2f: keep the robot still", c.value, c.limit);
    case ArmingCheckId::kAccelerometer:
      return format("differs from g by %.1f %%, expected below %.0f %%", 100.0 * c.value,
                    100.0 * c.limit);
    case ArmingCheckId::kAttitude:
      return format(
          "the quaternion leans %.1f deg off the vertical of the accelerometer, expected below "
          "%.0f; check its order (w x y z) and direction (IMU to world), else one "
          "sensor is wrong",
          57.29578 * c.value, 57.29578 * c.limit);
    case ArmingCheckId::kTilt:
      return format("%.1f deg off level, expected below %.0f", 57.29578 * c.value,
                    57.29578 * c.limit);
    case ArmingCheckId::kJoints:
      return format("%s %.3f rad outside its limits, expected below %.3f", motor, c.value, c.limit);
    case ArmingCheckId::kMotorOrder:
      return describe_order(c, config);
    case ArmingCheckId::kFootForce:
      return format("sum of foot forces differs from the weight by %.0f %%, expected below %.0f %%",
                    100.0 * c.value, 100.0 * c.limit);
    case ArmingCheckId::kFault:
      if (c.passed) return "no fault keeps the robot down";
      return format("%s keeps the robot down, expected no such fault",
                    to_string(static_cast<FaultId>(static_cast<int>(c.value))));
    case ArmingCheckId::kConflict:
      if (c.passed) return "no other program commands the robot";
      return "another program commands the robot, or a second robot sends LowStates; end it";
    case ArmingCheckId::kProgram:
      return format("getting up takes %.0f %% of a motor's torque limit, expected below %.0f %%",
                    100.0 * c.value, 100.0 * c.limit);
  }
  return "";
}

}  // namespace

const char* to_string(ArmingCheckId id) noexcept {
  constexpr std::array<const char*, kArmingChecks> names = {
      "link", "motor_mode", "temperature", "quaternion", "gyroscope", "accelerometer", "attitude",
      "tilt", "joints",     "motor_order", "foot_force", "program",   "fault",         "conflict"};
  return names[static_cast<int>(id)];
}

std::string describe(ArmingCheckId id, const ArmingCheck& check, const RobotConfig& config) {
  return std::string(to_string(id)) + ": " +
         (check.applies ? describe_value(id, check, config) : "not applicable");
}

std::string describe_failures(const ArmingReport& report, const RobotConfig& config) {
  const ArmingCheck& link = report.checks[static_cast<int>(ArmingCheckId::kLink)];
  if (!link.passed && link.limit == 0.0) return "link: no LowState yet";
  std::string text;
  for (int i = 0; i < kArmingChecks; ++i) {
    const ArmingCheck& check = report.checks[i];
    if (check.passed || !check.applies) continue;
    text += (text.empty() ? "" : "\n") + describe(static_cast<ArmingCheckId>(i), check, config);
  }
  return text;
}

}  // namespace surefoot
