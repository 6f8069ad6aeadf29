// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dynamics/dynamics.hpp"
#include "surefoot/types.hpp"

namespace surefoot {

/// Tells which legs are near singular, with hysteresis, and so which form the program takes.
///
/// A leg's determinant goes with sin q3 (cos q2 + cos(q2 + q3)): a straight knee, or a foot at the
/// height of its hip axis. Near that its row is soft in the general form. Real-time: yes.
class FormSelector {
 public:
  /// @param smallest_determinant [m^3] below which a leg's Jacobian is not inverted
  explicit FormSelector(double smallest_determinant)
      : smallest_determinant_(smallest_determinant) {}

  /// Judge the legs anew; returns kCondensed or kGeneral, or what was asked for.
  Form update(const Dynamics& dynamics, const Reference& reference, Form wanted) noexcept;

  const std::array<bool, kLegs>& singular() const noexcept { return singular_; }

 private:
  double smallest_determinant_;
  std::array<bool, kLegs> singular_{};
};

}  // namespace surefoot
