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

/// Units and scales of the QP's variables and rows, computed from the robot in its standing pose.
/// They bring the entries of the QP to order one for a robot of any size.
struct QpUnits {
  /// Throw surefoot::Error if a leg is singular in the standing pose.
  explicit QpUnits(const Robot& robot);
  double force = 1.0;    ///< [N] a quarter of the weight
  double length = 1.0;   ///< [m] mean depth of the feet below their hip axes
  double linear = 1.0;   ///< [m/s^2] linear acceleration of base and feet: g
  double angular = 1.0;  ///< [rad/s^2] angular acceleration of base and joints: g / length
  // Factors that bring the rows of the body tasks to length one in the standing pose.
  double scale_com = 1.0, scale_base = 1.0, scale_angular = 1.0, scale_momentum = 1.0;
  double smallest_determinant = 0.0;  ///< [m^3] a leg's Jacobian below it is not inverted
};

}  // namespace surefoot
