// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <pinocchio/multibody.hpp>

#include "common/text.hpp"
#include "robot/robot_checks.hpp"

namespace surefoot {

namespace {

// Usual greatest torque in the standing pose / torque limit. Chosen: more leaves no reserve for a
// push.
constexpr double kTorqueDoubt = 0.8;
// Greatest torque limit per weight and leg length. Chosen: Unitree's robots have 0.4 .. 0.7.
constexpr double kMaxTorqueShare = 20.0;

}  // namespace

void check_torque_limits(const RobotParts& parts, const std::array<LegPlaces, kLegs>& legs,
                         Doubts& doubts) {
  const RobotConfig& config = parts.config;
  double mass = 0.0;
  for (const auto& inertia : parts.model.inertias) mass += inertia.mass();
  for (int i = 0; i < kMotors; ++i) {
    const LegPlaces& L = legs[i / kLegJoints];
    const int k = i % kLegJoints;
    const Vector3 lever = L.foot - L.joints[k];
    // An upward force of a quarter of the weight at the foot, about the joint's axis.
    const double needed = 0.25 * mass * kGravity * std::abs(k == 0 ? lever.y() : lever.x());
    const std::string what = "torque limit of " + config.joint_names[i];
    const std::string got = to_text(config.tau_max[i]) + " N.m";
    if (needed > kTorqueDoubt * config.tau_max[i]) {
      doubts.push_back(what + ": " + got + " leaves no reserve, because the standing pose needs " +
                       to_text(needed) + " N.m");
    }
    const double most = kMaxTorqueShare * mass * kGravity * (L.thigh + L.calf);
    if (config.tau_max[i] > most) {
      fail_check(config, what, got,
                 "at most " + to_text(most) +
                     " N.m, 20 times the weight at the length of a leg; "
                     "give <limit effort> the torque of the motor");
    }
  }
}

}  // namespace surefoot
