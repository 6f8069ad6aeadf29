// SPDX-License-Identifier: BSD-3-Clause
#include "gait/foot_contacts.hpp"

#include <algorithm>

namespace surefoot {

namespace {

// Contact confidences. Chosen as wide hysteresis: a foot has landed above the first, and has lost
// the ground below the second.
constexpr double kLanded = 0.7;
constexpr double kLost = 0.3;
// Share of the swing before which a contact is not a landing: the foot still leaves the ground, or
// it hits an obstacle, and the swing continues over it.
constexpr double kEarliestLanding = 0.6;
// [s] Ramp of the planned load after touchdown and before lift-off.
constexpr double kLoadRamp = GaitClock::kUnloadingTime;
// Planned loads of feet that have landed early, and of feet that still reach for the ground.
constexpr double kEarlyLoad = 0.2;
constexpr double kLateLoad = 0.1;

}  // namespace

void FootContacts::update(const GaitClock& clock, const Eigen::Vector4d& contact,
                          const std::array<bool, kLegs>& lifting, double dt) noexcept {
  for (int leg = 0; leg < kLegs; ++leg) {
    const FootPhase last = phase_[leg];
    const bool was_in_stance = in_stance(leg);
    phase_[leg] = lifting[leg] ? FootPhase::kSwing : next_phase(leg, clock, contact[leg]);
    lifted_off_[leg] = last != FootPhase::kSwing && phase_[leg] == FootPhase::kSwing;
    landed_[leg] = !was_in_stance && in_stance(leg);
    lost_[leg] = was_in_stance && phase_[leg] == FootPhase::kLateTouchdown;
    double target = 0.0;
    if (phase_[leg] == FootPhase::kStance)
      target = std::min(1.0, clock.time_to_liftoff(leg) / kLoadRamp);
    // A foot that bounces after an early landing carries nothing until it is down again.
    if (phase_[leg] == FootPhase::kEarlyTouchdown && contact[leg] > kLost) target = kEarlyLoad;
    if (phase_[leg] == FootPhase::kLateTouchdown) target = kLateLoad;
    load_[leg] = std::min(target, load_[leg] + dt / kLoadRamp);
  }
}

FootPhase FootContacts::next_phase(int leg, const GaitClock& clock, double contact) noexcept {
  const FootPhase last = phase_[leg];
  if (clock.in_swing(leg)) {
    const bool landed = contact > kLanded && clock.swing_progress(leg) > kEarliestLanding;
    if (last == FootPhase::kEarlyTouchdown || (last == FootPhase::kSwing && landed)) {
      return FootPhase::kEarlyTouchdown;
    }
    return FootPhase::kSwing;
  }
  if (last == FootPhase::kStance) return contact < kLost ? FootPhase::kLateTouchdown : last;
  return contact > kLanded ? FootPhase::kStance : FootPhase::kLateTouchdown;
}

bool FootContacts::others_in_stance(int leg) const noexcept {
  for (int other = 0; other < kLegs; ++other) {
    if (other != leg && phase_[other] != FootPhase::kStance) return false;
  }
  return true;
}

// A foot that is about to lift off need not land first.
bool FootContacts::late(const GaitClock& clock, double min_load) const noexcept {
  for (int leg = 0; leg < kLegs; ++leg) {
    if (clock.time_to_liftoff(leg) <= kLoadRamp || clock.waits(leg)) continue;
    if (phase_[leg] == FootPhase::kLateTouchdown || load_[leg] < min_load) return true;
  }
  return false;
}

}  // namespace surefoot
