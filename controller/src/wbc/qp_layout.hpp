// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/robot.hpp"
#include "wbc/friction_cone.hpp"

namespace surefoot {

/// Where the inequality rows lie, alike in both forms:
///   per foot kFacets of the friction pyramid and the normal force (hard);
///   per foot the hold-down force; per joint its torque; per joint its acceleration (elastic).
/// Elastic rows give way in groups, one slack each: the hold-down of a foot, the torques of a leg,
/// the accelerations of a leg; joints beyond the legs make a fifth "leg".
struct QpLayout {
  static constexpr int kForces = 3 * kLegs;
  static constexpr int kFootRows = kFacets + 1;
  static constexpr int kHard = kLegs * kFootRows;
  static constexpr int kLegGroups = kLegs + 1;
  static constexpr int kGroups = kLegs + 2 * kLegGroups;

  explicit QpLayout(int joint_count) : joints(joint_count) {}
  int hold_down() const noexcept { return kHard; }
  int torque() const noexcept { return kHard + kLegs; }
  int acceleration() const noexcept { return torque() + joints; }
  int rows() const noexcept { return acceleration() + joints; }

  static constexpr int hold_down_group(int leg) noexcept { return leg; }
  static constexpr int torque_group(int leg) noexcept { return kLegs + leg; }
  static constexpr int acceleration_group(int leg) noexcept { return kLegs + kLegGroups + leg; }

  int joints;
};

/// What the program is measured in, from the robot in its standing pose: with these, entries of the
/// program are of order one for a robot of any size.
struct QpUnits {
  /// Throws surefoot::Error when a leg is singular in the standing pose.
  explicit QpUnits(const Robot& robot);
  double force = 1.0;    ///< [N] a quarter of the weight
  double length = 1.0;   ///< [m] from hip axis to foot
  double linear = 1.0;   ///< [m/s^2] of base and feet: g
  double angular = 1.0;  ///< [rad/s^2] of base and joints: g / length
  double scale_com = 1.0, scale_base = 1.0, scale_angular = 1.0, scale_momentum = 1.0;
  double smallest_determinant = 0.0;  ///< [m^3] of a leg's Jacobian that may still be inverted
};

}  // namespace surefoot
