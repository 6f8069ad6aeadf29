// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dynamics/dynamics.hpp"
#include "surefoot/types.hpp"

namespace surefoot {

/// Detects legs near a singularity, with hysteresis, and selects the form of the QP.
///
/// The determinant of a leg's Jacobian is proportional to sin q3 (cos q2 + cos(q2 + q3)). It is
/// zero for a straight knee and for a foot at the height of its hip axis. Near a singularity the
/// general form takes over. At the switch both forms give the same torques. Closer to the
/// singularity the foot acceleration changes gradually from an equality to a task in the cost,
/// with a softness of 0 .. 1. Real-time: yes.
class FormSelector {
 public:
  /// @param smallest_determinant [m^3] legs with a smaller |det J| are not inverted
  explicit FormSelector(double smallest_determinant)
      : smallest_determinant_(smallest_determinant) {}

  /// Update singular() and softness() for this pose.
  /// @return `requested` unless it is kAuto. For kAuto: kGeneral if a leg is nearly singular or the
  ///   robot has further joints, else kCondensed
  QpForm update(const Dynamics& dynamics, const Reference& reference, QpForm requested) noexcept;

  const std::array<bool, kLegs>& singular() const noexcept { return singular_; }
  /// Softness of each foot. 0: the QP meets its acceleration exactly. 1: its acceleration is a task
  /// of weight `weight_foot_soft`. Between 0 and 1: a task of larger weight.
  const Eigen::Vector4d& softness() const noexcept { return softness_; }

 private:
  double smallest_determinant_;
  std::array<bool, kLegs> singular_{};
  Eigen::Vector4d softness_ = Eigen::Vector4d::Zero();
};

}  // namespace surefoot
