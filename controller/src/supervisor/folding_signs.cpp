// SPDX-License-Identifier: BSD-3-Clause
// What legs that do not fold as they should say of the robot.
#include <algorithm>
#include <cmath>

#include "supervisor/lean.hpp"
#include "supervisor/leg_folding.hpp"

namespace surefoot {

namespace {
constexpr double kStirred = 0.1;      // [rad] of the body ...
constexpr double kHipStirred = 0.45;  // [rad] ... and of a hip: that is no room, but a way
}  // namespace

int LegFolding::most_tries() const noexcept {
  int most = 0;
  for (const Leg& leg : legs_) most = std::max(most, leg.tries);
  return most;
}

std::array<bool, kLegs> LegFolding::folded_side(const Vector12& measured) const noexcept {
  std::array<bool, kLegs> side = {};
  if (roll_.lets_go() || most_tries() < next_weighing_) return side;
  const int enough = roll_.rolls() > 0 ? 0 : kCaught;
  for (int leg = 0; leg < kLegs; ++leg) {
    const int caught = std::max(legs_[other_side(leg)].tries, legs_[diagonal(leg)].tries);
    side[leg] = caught >= enough && folded(leg, measured) && folded(other_end(leg), measured);
  }
  return side;
}

// Calves and thighs of a lying robot may have some room where nothing else moves.
bool LegFolding::pinned(const Vector12& measured, const Vector3& up) const noexcept {
  bool all = roll_.rolls() == 0 && std::abs(lean(up) - lean_) < kStirred;
  for (int leg = 0; leg < kLegs; ++leg) {
    const int hip = kLegJoints * leg;
    const bool caught = legs_[leg].tries > 0 && !folded(leg, measured);
    all = all && caught && std::abs(measured[hip] - first_[hip]) < kHipStirred;
  }
  return all;
}

}  // namespace surefoot
