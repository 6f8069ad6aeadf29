// SPDX-License-Identifier: BSD-3-Clause
#include "wbc/form_selector.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace surefoot {

namespace {
// Depth: of a stance foot below its hip axis. Determinants are relative to smallest_determinant.
// Chosen by hand; tests: test_form_selector.cpp, test_singular_legs.cpp.
// [m] a regular leg becomes singular below it. Above: the 0.07 of the gain reach_foot_depth, which
// references keep.
constexpr double kSmallestDepth = 0.05;
constexpr double kRegularDepth = 0.06;       // [m] a singular leg becomes regular: 1 cm hysteresis
constexpr double kRegularDeterminant = 1.2;  // a singular leg becomes regular: 20 % hysteresis
// Ranges below kSmallestDepth and below 1 in which softness rises to 1: wide enough that torques do
// not step, and over before the singularity itself.
constexpr double kSoftDepth = 0.02;       // [m]
constexpr double kSoftDeterminant = 0.7;  // of smallest_determinant
}  // namespace

QpForm FormSelector::update(const Dynamics& dynamics, const Reference& reference,
                            QpForm requested) noexcept {
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
  if (requested != QpForm::kAuto) return requested;
  const bool any = std::any_of(singular_.begin(), singular_.end(), [](bool s) { return s; });
  return dynamics.condensable() && !any ? QpForm::kCondensed : QpForm::kGeneral;
}

}  // namespace surefoot
