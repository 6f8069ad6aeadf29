// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "gait/gait_clock.hpp"
#include "surefoot/math.hpp"

namespace surefoot {

/// What a foot does: the schedule of the clock, corrected by the contact confidence.
enum class FootPhase {
  kStance,          ///< scheduled to carry load, and in contact
  kSwing,           ///< scheduled to swing, and in the air
  kEarlyTouchdown,  ///< landed before its time
  kLateTouchdown    ///< scheduled to carry load, and not in contact
};

/// Phases and planned loads of all feet. Real-time: yes.
class FootContacts {
 public:
  /// All feet are in stance with full load.
  void start() noexcept { *this = {}; }

  /// @param contact contact confidence per foot, 0 .. 1
  /// @param lifting feet that lift over an obstacle: they swing, whatever the clock says
  void update(const GaitClock& clock, const Eigen::Vector4d& contact,
              const std::array<bool, kLegs>& lifting, double dt) noexcept;

  /// Let a foot in the air begin a new swing from where it is: it lifts off in the next update.
  void restart_swing(int leg) noexcept { phase_[leg] = FootPhase::kStance; }

  FootPhase phase(int leg) const noexcept { return phase_[leg]; }
  bool in_stance(int leg) const noexcept {
    return phase_[leg] == FootPhase::kStance || phase_[leg] == FootPhase::kEarlyTouchdown;
  }
  bool lifted_off(int leg) const noexcept { return lifted_off_[leg]; }  ///< in this tick
  bool landed(int leg) const noexcept { return landed_[leg]; }          ///< in this tick
  bool lost(int leg) const noexcept { return lost_[leg]; }    ///< the ground was lost in this tick
  double load(int leg) const noexcept { return load_[leg]; }  ///< planned, 0 .. 1
  bool others_in_stance(int leg) const noexcept;              ///< all feet but that of `leg`
  /// Return whether a foot that should carry load has not landed, or has a smaller planned load
  /// than `min_load`.
  bool late(const GaitClock& clock, double min_load) const noexcept;

 private:
  FootPhase next_phase(int leg, const GaitClock& clock, double contact) noexcept;

  std::array<FootPhase, kLegs> phase_{};
  std::array<bool, kLegs> lifted_off_{}, landed_{}, lost_{};
  std::array<double, kLegs> load_ = {1.0, 1.0, 1.0, 1.0};
};

}  // namespace surefoot
