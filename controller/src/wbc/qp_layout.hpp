// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/robot.hpp"
#include "wbc/friction_cone.hpp"

namespace surefoot {

/// Layout of the inequality rows, the same in the condensed and in the general form:
///   hard:    per foot kFacets rows of the friction pyramid and one of the normal force;
///   elastic: one hold-down row per foot, one torque and one acceleration row per joint.
/// The elastic rows of one group share one slack. The groups are the hold-down of a foot, the
/// torques of a leg and the accelerations of a leg. Joints beyond the legs form a fifth "leg".
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

}  // namespace surefoot
