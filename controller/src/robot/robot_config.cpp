// SPDX-License-Identifier: BSD-3-Clause
#include "surefoot/robot_config.hpp"

#include <algorithm>
#include <cmath>

#include "common/text.hpp"
#include "surefoot/error.hpp"

namespace surefoot {

namespace {

constexpr double kMaxAngle = 6.2832;  // [rad] one turn; leg joints move less
constexpr double kRadPerDegree = 0.017453292519943295;
// [rad/s] Greatest speed of a joint. Chosen: Unitree's robots have 14 .. 52; a larger value stands
// for "no limit".
constexpr double kMaxSpeed = 200.0;
// [kg.m^2] Greatest armature. Chosen: b1 has 0.13.
constexpr double kMaxArmature = 10.0;

[[noreturn]] void fail(const RobotConfig& config, const std::string& field, const std::string& got,
                       const std::string& expected) {
  throw Error("robot '" + config.name + "', " + field + ": got " + got + ", expected " + expected);
}

void check_positive(const RobotConfig& config, const char* field, const Vector12& values,
                    bool zero_allowed) {
  for (int i = 0; i < kMotors; ++i) {
    const bool good =
        std::isfinite(values[i]) && (values[i] > 0.0 || (zero_allowed && values[i] == 0.0));
    if (!good) {
      fail(config, std::string(field) + " of " + config.joint_names[i], to_text(values[i]),
           zero_allowed ? "a number >= 0" : "a number > 0");
    }
  }
}

// A .robot file has one line for each field, so a name must not contain control characters.
void check_name(const RobotConfig& config, const std::string& field, const std::string& name) {
  const bool printable = std::none_of(name.begin(), name.end(), [](char c) {
    return static_cast<unsigned char>(c) < ' ' || c == '\x7f';
  });
  if (name.empty() || !printable) {
    fail(config, field, "'" + name + "'", "a name on one line; correct it in URDF and TOML");
  }
}

void check_names(const RobotConfig& config) {
  if (config.name.empty() || config.name.find_first_of(" \n\t\r\v\f") != std::string::npos) {
    fail(config, "name", "'" + config.name + "'", "a word without spaces");
  }
  check_name(config, "name", config.name);
  for (int i = 0; i < kMotors; ++i) {
    check_name(config, "joint name " + std::to_string(i), config.joint_names[i]);
    for (int j = 0; j < i; ++j) {
      if (config.joint_names[i] == config.joint_names[j]) {
        fail(config, "joint names", "'" + config.joint_names[i] + "' twice", "12 different names");
      }
    }
  }
  for (int leg = 0; leg < kLegs; ++leg) {
    check_name(config, "foot frame " + std::to_string(leg), config.foot_frames[leg]);
    for (int other = 0; other < leg; ++other) {
      if (config.foot_frames[leg] == config.foot_frames[other]) {
        fail(config, "foot frames", "'" + config.foot_frames[leg] + "' twice", "4 different names");
      }
    }
  }
}

void check_positions(const RobotConfig& config) {
  for (int i = 0; i < kMotors; ++i) {
    const double lower = config.q_lower[i], upper = config.q_upper[i], q = config.q_standing[i];
    if (!(lower < upper && lower >= -kMaxAngle && upper <= kMaxAngle)) {
      fail(config, "position limits of " + config.joint_names[i],
           to_text(lower) + " .. " + to_text(upper) + " rad",
           "lower < upper, within one turn (6.28 rad); correct URDF or [limits]");
    }
    if (!(q >= lower && q <= upper)) {
      const double in_rad = q * kRadPerDegree;
      const bool degrees = std::abs(q) > kMaxAngle && in_rad >= lower && in_rad <= upper;
      fail(config, "standing pose of " + config.joint_names[i], to_text(q),
           "a value inside " + to_text(lower) + " .. " + to_text(upper) + " rad" +
               (degrees ? "; this looks like degrees, convert it to radians" : ""));
    }
    if (config.dq_max[i] > kMaxSpeed || config.no_load_speed[i] > kMaxSpeed) {
      fail(config, "velocity limit of " + config.joint_names[i],
           to_text(std::max(config.dq_max[i], config.no_load_speed[i])) + " rad/s",
           "at most 200 rad/s; give <limit velocity> the speed of the motor");
    }
    const JointRange range = motion_range(config, i);
    if (!(q >= range.lower && q <= range.upper)) {
      fail(config, "hip_inward", to_text(config.hip_inward),
           "at least " + to_text(std::abs(q)) + ", the angle of " + config.joint_names[i] +
               " in the standing pose");
    }
    if (!(config.corner_speed[i] < config.no_load_speed[i])) {
      fail(config, "corner_speed of " + config.joint_names[i], to_text(config.corner_speed[i]),
           "less than no_load_speed " + to_text(config.no_load_speed[i]));
    }
  }
}

}  // namespace

void RobotConfig::validate() const {
  check_names(*this);
  check_positive(*this, "dq_max", dq_max, false);
  check_positive(*this, "tau_max", tau_max, false);
  check_positive(*this, "corner_speed", corner_speed, true);
  check_positive(*this, "no_load_speed", no_load_speed, false);
  check_positive(*this, "armature", armature, true);
  if (!(std::isfinite(hip_inward) && hip_inward > 0.0)) {
    fail(*this, "hip_inward", to_text(hip_inward), "a number > 0, in rad");
  }
  for (int i = 0; i < kMotors; ++i) {
    if (armature[i] > kMaxArmature) {
      fail(*this, "armature of " + joint_names[i], to_text(armature[i]),
           "at most 10 kg.m^2: rotor inertia times squared gear ratio");
    }
  }
  check_positions(*this);
  if (!(foot_radius > 0.0 && foot_radius < 0.2)) {
    fail(*this, "foot radius", to_text(foot_radius), "above 0, below 0.2 m");
  }
  if (!(std::isfinite(friction) && friction > 0.0 && friction <= 2.0)) {
    fail(*this, "friction", to_text(friction), "0 < friction <= 2");
  }
  if (!p_base_imu.allFinite())
    fail(*this, "IMU position", "NaN or infinity", "finite numbers, in m");
  if (!(std::abs(quat_base_imu.norm() - 1.0) < 1e-6)) {
    fail(*this, "IMU quaternion norm", to_text(quat_base_imu.norm()), "1");
  }
  gains.validate();
}

JointRange motion_range(const RobotConfig& config, int i) noexcept {
  JointRange range{config.q_lower[i], config.q_upper[i]};
  if (i % kLegJoints != 0) return range;
  // The hip axis points forward, so the foot of a left leg moves under the trunk at negative
  // angles.
  const bool left = i / kLegJoints % 2 == 1;
  if (left) {
    range.lower = std::max(range.lower, -config.hip_inward);
  } else {
    range.upper = std::min(range.upper, config.hip_inward);
  }
  return range;
}

double motor_torque_limit(const RobotConfig& config, int i, double dq, double sign) noexcept {
  const double driving_speed = sign < 0.0 ? -dq : dq;  // negative while the motor brakes
  if (driving_speed <= config.corner_speed[i]) return config.tau_max[i];
  const double fraction = (config.no_load_speed[i] - driving_speed) /
                          (config.no_load_speed[i] - config.corner_speed[i]);
  return config.tau_max[i] * (fraction > 0.0 ? fraction : 0.0);
}

}  // namespace surefoot
