// SPDX-License-Identifier: BSD-3-Clause
#include "wbc/form_selector.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace surefoot {

namespace {
// Depth: of a stance foot below its hip axis. Determinants are relative to smallest_determinant.
constexpr double kSmallestDepth = 0.05;      // [m] a regular leg becomes singular below it
constexpr double kRegularDepth = 0.06;       // [m] a singular leg becomes regular above it
constexpr double kRegularDeterminant = 1.2;  // a singular leg becomes regular above it
constexpr double kSoftDepth = 0.02;          // [m] this far below kSmallestDepth softness is 1
constexpr double kSoftDeterminant = 0.7;     // this far below 1 softness is 1
}  // namespace

QpForm FormSelector::update(const Dynamics& dynamics, const Reference& reference,
                            QpForm wanted) noexcept {
  for (int leg = 0; leg < kLegs; ++leg) {
    const LegDynamics& L = dynamics.legs()[leg];
    const double determinant = std::abs(L.J_leg.determinant()) / smallest_determinant_;
    const bool deep =
        L.depth > (singular_[leg] ? kRegularDepth : kSmallestDepth) || !reference.feet[leg].stance;
    singular_[leg] = !deep || determinant < (singular_[leg] ? kRegularDeterminant : 1.0);
    const double shallow =
        reference.feet[leg].stance ? (kSmallestDepth - L.depth) / kSoftDepth : 0.0;
    const double soft = std::max(shallow, (1.0 - determinant) / kSoftDeterminant);
    softness_[leg] = std::clamp(soft, 0.0, 1.0);
  }
  if (wanted != QpForm::kAuto) return wanted;
  const bool any = std::any_of(singular_.begin(), singular_.end(), [](bool s) { return s; });
  return dynamics.condensable() && !any ? QpForm::kCondensed : QpForm::kGeneral;
}

}  // namespace surefoot
