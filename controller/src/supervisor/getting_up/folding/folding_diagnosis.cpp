// SPDX-License-Identifier: BSD-3-Clause
// Finds out why a folding failed.
#include <algorithm>
#include <cmath>

#include "supervisor/common/tilt.hpp"
#include "supervisor/getting_up/folding/leg_folding.hpp"

namespace surefoot {

namespace {
// The constants are chosen by hand; test: body_that_blocks_all_legs_is_pinned.
// [rad] Change of tilt from which the body moves freely. Larger than noise, and smaller than the
// tilt of a lift that frees a leg.
constexpr double kMinTiltChange = 0.1;
constexpr double kMinHipMotion = 0.45;  // [rad] motion of a hip that is more than play
}  // namespace

int LegFolding::max_catches() const noexcept {
  int most = 0;
  for (const Leg& leg : legs_) most = std::max(most, leg.catches);
  return most;
}

std::array<bool, kLegs> LegFolding::folded_side(const Vector12& measured) const noexcept {
  std::array<bool, kLegs> side = {};
  if (rollover_.releases_legs() || max_catches() < next_weighing_) return side;
  const int min_tries = rollover_.rolls() > 0 ? 0 : kMinCatches;
  for (int leg = 0; leg < kLegs; ++leg) {
    const int caught =
        std::max(legs_[lateral_neighbor(leg)].catches, legs_[diagonal_leg(leg)].catches);
    side[leg] = caught >= min_tries && folded(leg, measured) &&
                folded(longitudinal_neighbor(leg), measured);
  }
  return side;
}

// Calves and thighs are not checked, because they may have some play even if the leg is blocked.
bool LegFolding::pinned(const Vector12& measured, const Vector3& up) const noexcept {
  bool all = rollover_.rolls() == 0 && std::abs(tilt_angle(up) - tilt_start_) < kMinTiltChange;
  for (int leg = 0; leg < kLegs; ++leg) {
    const int hip = kLegJoints * leg;
    const bool caught = legs_[leg].catches > 0 && !folded(leg, measured);
    all = all && caught && std::abs(measured[hip] - q_start_[hip]) < kMinHipMotion;
  }
  return all;
}

}  // namespace surefoot
