// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/robot.hpp"
#include "wbc/friction_cone.hpp"

namespace surefoot {

/// Order of the inequality rows, which is the same in the condensed and in the general form:
///   hard:    for each foot kFacets rows of the friction pyramid, then one row of the normal force;
///   elastic: one hold-down row for each foot, one torque row for each joint, one acceleration row
///   for each joint.
/// The elastic rows of a group share one slack. The groups are the hold-down of each foot, the
/// torques of each leg and the accelerations of each leg. All joints outside the legs form a fifth
/// "leg".
struct QpLayout {
  static constexpr int kForces = 3 * kLegs;
  static constexpr int kFootRows = kFacets + 1;
  static constexpr int kHard = kLegs * kFootRows;
  static constexpr int kLegGroups = kLegs + 1;
  static constexpr int kGroups = kLegs + 2 * kLegGroups;

  explicit QpLayout(int joint_count) : joints(joint_count) {}
  // Index of the first row of each kind, and the number of all rows:
  int hold_down() const noexcept { return kHard; }
  int torque() const noexcept { return kHard + kLegs; }
  int acceleration() const noexcept { return torque() + joints; }
  int rows() const noexcept { return acceleration() + joints; }

  static constexpr int hold_down_group(int leg) noexcept { return leg; }
  static constexpr int torque_group(int leg) noexcept { return kLegs + leg; }
  static constexpr int acceleration_group(int leg) noexcept { return kLegs + kLegGroups + leg; }

  int joints;
};

}  // namespace surefoot
