// SPDX-License-Identifier: BSD-3-Clause
// Decides whether a side is weighed alone, and whether the legs are pinned, when folding does not
// succeed.
#include <algorithm>
#include <cmath>

#include "supervisor/common/tilt.hpp"
#include "supervisor/getting_up/folding/leg_folding.hpp"

namespace surefoot {

namespace {
// The constants are chosen by hand; test: body_that_blocks_all_legs_is_pinned.
// [rad] Change of tilt from which the body counts as free to move. Larger than noise, and smaller
// than the tilt change when a leg lifts the body and comes free.
constexpr double kMinTiltChange = 0.1;
// [rad] Motion of a hip from which the leg counts as free to move. Larger than the play of a
// blocked leg.
constexpr double kMinHipMotion = 0.45;
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
    // The largest number of catches of the two legs on the other side.
    const int caught =
        std::max(legs_[lateral_neighbor(leg)].catches, legs_[diagonal_leg(leg)].catches);
    side[leg] = caught >= min_tries && folded(leg, measured) &&
                folded(longitudinal_neighbor(leg), measured);
  }
  return side;
}

// Only hips are compared with kMinHipMotion, because thigh and calf of a blocked leg can still move
// a little.
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
