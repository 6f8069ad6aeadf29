// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dynamics/dynamics.hpp"
#include "surefoot/types.hpp"

namespace surefoot {

/// Tells which legs are near singular, with hysteresis, and so which form the program takes.
///
/// A leg's determinant goes with sin q3 (cos q2 + cos(q2 + q3)): a straight knee, or a foot at the
/// height of its hip axis. Near that the form is general, whose torques are the condensed form's to
/// begin with; nearer still the foot's row gives way, by degrees. Real-time: yes.
class FormSelector {
 public:
  /// @param smallest_determinant [m^3] below which a leg's Jacobian is not inverted
  explicit FormSelector(double smallest_determinant)
      : smallest_determinant_(smallest_determinant) {}

  /// Judge the legs anew; returns kCondensed or kGeneral, or what was asked for.
  QpForm update(const Dynamics& dynamics, const Reference& reference, QpForm wanted) noexcept;

  const std::array<bool, kLegs>& singular() const noexcept { return singular_; }
  /// How much each foot's row gives way: 0 met exactly .. 1 as cheap as `weight_foot_soft` has it.
  const Eigen::Vector4d& softness() const noexcept { return softness_; }

 private:
  double smallest_determinant_;
  std::array<bool, kLegs> singular_{};
  Eigen::Vector4d softness_ = Eigen::Vector4d::Zero();
};

}  // namespace surefoot
