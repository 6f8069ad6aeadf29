// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "surefoot/robot.hpp"

/// Checks of a robot with its model in hand. Every Robot passes them in its constructor, so URDF,
/// Pinocchio model and .robot file are judged alike. Each function throws surefoot::Error, or adds
/// a sentence to `doubts` for a value that is unusual but possible. Real-time: no.
namespace surefoot {

/// Parts of a robot that has not been constructed yet.
struct RobotParts {
  const pinocchio::Model& model;
  const RobotConfig& config;
  const std::array<int, kMotors>& motor_to_q;
  const std::array<int, kMotors>& motor_to_v;
  const std::array<int, kLegs>& foot_frame_ids;
};

using Doubts = std::vector<std::string>;

/// Check that each moving body has a mass and a physically possible inertia.
void check_bodies(const RobotParts& parts, Doubts& doubts);

/// Places of one leg in base axes.
struct LegPlaces {
  Vector3 joints[kLegJoints];  ///< [m] origins in the standing pose
  Vector3 axes[kLegJoints];    ///< at zero joint angles; zero for a joint that does not turn
  Vector3 foot;                ///< [m] in the standing pose
  double thigh, calf;          ///< [m] lengths, perpendicular to the axes
};

/// Compute the places of all legs, FR FL RR RL.
std::array<LegPlaces, kLegs> measure_legs(const RobotParts& parts);

/// Check joint axes, link lengths and the positions of the feet in the standing pose.
void check_legs(const RobotConfig& config, const std::array<LegPlaces, kLegs>& legs,
                Doubts& doubts);

/// Check that the torque limits fit the weight of the robot.
void check_torque_limits(const RobotParts& parts, const std::array<LegPlaces, kLegs>& legs,
                         Doubts& doubts);

/// Throw surefoot::Error: "robot 'NAME', WHAT: got GOT, expected EXPECTED".
[[noreturn]] void fail_check(const RobotConfig& config, const std::string& what,
                             const std::string& got, const std::string& expected);

}  // namespace surefoot
