// SPDX-License-Identifier: BSD-3-Clause
#include "wbc/form_selector.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace surefoot {

namespace {
// A depth is the distance [m] of a stance foot below its hip axis. A determinant is |det J| divided
// by smallest_determinant. All constants are chosen by hand. Tests: test_form_selector.cpp,
// test_singular_legs.cpp.
//
// [m] Depth below which a regular leg becomes singular. Less than 0.07 m, the smallest depth of a
// pose that BodyReference may request (gain reach_foot_depth).
constexpr double kSingularDepth = 0.05;
constexpr double kRegularDepth = 0.06;  // [m] depth above which a singular leg becomes regular
// Determinant above which a singular leg becomes regular.
constexpr double kRegularDeterminant = 1.2;
// The softness rises from 0 to 1 while the depth falls by kSoftDepth below kSingularDepth, or while
// the determinant falls by kSoftDeterminant below 1. These ranges are wide enough that the torques
// do not jump, and they end before the singularity itself.
constexpr double kSoftDepth = 0.02;  // [m]
constexpr double kSoftDeterminant = 0.7;
}  // namespace

QpForm FormSelector::update(const Dynamics& dynamics, const Reference& reference,
                            QpForm requested) noexcept {
  for (int leg = 0; leg < kLegs; ++leg) {
    const LegDynamics& L = dynamics.legs()[leg];
    const double determinant = std::abs(L.J_leg.determinant()) / smallest_determinant_;
    const bool depth_is_regular =
        L.depth > (singular_[leg] ? kRegularDepth : kSingularDepth) || !reference.feet[leg].stance;
    singular_[leg] =
        !depth_is_regular || determinant < (singular_[leg] ? kRegularDeterminant : 1.0);
    const double depth_softness =
        reference.feet[leg].stance ? (kSingularDepth - L.depth) / kSoftDepth : 0.0;
    const double leg_softness = std::max(depth_softness, (1.0 - determinant) / kSoftDeterminant);
    softness_[leg] = std::clamp(leg_softness, 0.0, 1.0);
  }
  if (requested != QpForm::kAuto) return requested;
  const bool any_singular =
      std::any_of(singular_.begin(), singular_.end(), [](bool s) { return s; });
  return dynamics.condensable() && !any_singular ? QpForm::kCondensed : QpForm::kGeneral;
}

}  // namespace surefoot
