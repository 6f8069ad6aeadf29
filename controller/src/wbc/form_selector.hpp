// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dynamics/dynamics.hpp"
#include "surefoot/types.hpp"

namespace surefoot {

/// Detects legs near a singularity, with hysteresis, and selects the form of the QP.
///
/// The determinant of a leg's Jacobian is proportional to sin q3 (cos q2 + cos(q2 + q3)). It is
/// zero for a straight knee, and for a foot at the height of its hip axis. (q2: thigh joint, q3:
/// calf joint.) Near a singularity the general form replaces the condensed form; at the switch both
/// forms give the same torques. Closer to the singularity the foot acceleration gradually changes
/// from an equality to a task in the cost. The softness of the foot, 0 .. 1, measures this change.
/// Real-time: yes.
class FormSelector {
 public:
  /// @param smallest_determinant [m^3] a leg with a smaller |det J| is singular and is not inverted
  explicit FormSelector(double smallest_determinant)
      : smallest_determinant_(smallest_determinant) {}

  /// Update singular() and softness() for this pose.
  /// @return `requested` unless it is kAuto. For kAuto: kGeneral if a leg is nearly singular or the
  ///   robot has further joints, else kCondensed
  QpForm update(const Dynamics& dynamics, const Reference& reference, QpForm requested) noexcept;

  const std::array<bool, kLegs>& singular() const noexcept { return singular_; }
  /// Softness of each foot, FR FL RR RL. 0: the QP meets the foot's acceleration exactly. 1: the
  /// foot's acceleration is a task with weight `weight_foot_soft`. Between 0 and 1: a task with
  /// larger weight.
  const Eigen::Vector4d& softness() const noexcept { return softness_; }

 private:
  double smallest_determinant_;
  std::array<bool, kLegs> singular_{};
  Eigen::Vector4d softness_ = Eigen::Vector4d::Zero();
};

}  // namespace surefoot
