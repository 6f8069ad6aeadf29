// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>

#include "surefoot/low_level.hpp"

namespace surefoot {

/// Times of a gait. Leg i is in stance while its phase, frac(phase + offset[i]), is below duty.
/// Real-time: yes.
struct GaitTiming {
  double period = 0.42;                                     ///< [s] of one cycle
  double duty = 0.5;                                        ///< share of the period in stance
  std::array<double, kLegs> offset = {0.0, 0.5, 0.5, 0.0};  ///< FR FL RR RL
  double stance_time() const noexcept { return duty * period; }
  double swing_time() const noexcept { return (1.0 - duty) * period; }
};

/// Clock of a gait: the phase of each leg. If a foot is due to lift off while another has not
/// landed, it stays in stance and the clock waits. Without the wait, a push that lifts the body
/// would leave no foot on the ground. Real-time: yes.
class GaitClock {
 public:
  /// [s] Time in which a foot unloads before it lifts off. Chosen. If smaller: the torques jump. If
  /// larger: the foot carries its full load for less of its stance.
  static constexpr double kUnloadingTime = 0.02;

  /// Start with all legs in stance, as if those with offset 0 had just landed. A leg whose phase is
  /// in the swing skips that swing.
  void start() noexcept {
    *this = {};
    grounded_.fill(true);
  }
  /// Start with `leg`, and all legs that move with it, at the begin of their swing.
  void start_swing(const GaitTiming& timing, int leg) noexcept {
    *this = {};
    timing_ = timing;
    phase_ = fraction(timing.duty - timing.offset[leg]);
  }

  /// Continue the swing of `leg` with another timing; the share of the swing that is over stays.
  /// The other legs that move with it skip this swing.
  void continue_swing(const GaitTiming& timing, int leg) noexcept;

  /// Advance the phase.
  /// @param max_wait longest wait for feet that should have landed [s]; 0: do not wait. After a
  ///   wait, the feet that waited unload for kUnloadingTime before they lift off
  /// @param stop whether no further foot shall lift off. After `stop`, a foot that skipped its
  ///   swing lifts off one cycle later
  void advance(const GaitTiming& timing, double max_wait, bool stop, double dt) noexcept;

  bool in_swing(int leg) const noexcept {
    return phase_of(leg) >= timing_.duty && !grounded_[leg] && !waits_[leg];
  }
  /// Return whether the lift-off of the leg is delayed: it waits for late feet, or unloads after
  /// the wait.
  bool waits(int leg) const noexcept { return waits_[leg]; }
  /// Share of the swing that is over, 0 .. 1; 0 in stance.
  double swing_progress(int leg) const noexcept;
  double stance_progress(int leg) const noexcept;    ///< share of the stance that is over, 0 .. 1
  double time_to_touchdown(int leg) const noexcept;  ///< [s] 0 in stance
  double time_since_touchdown(int leg) const noexcept;  ///< [s] 0 in swing
  double time_to_liftoff(
      int leg) const noexcept;  ///< [s] 0 in swing; a period if it skips its swing or waits
  const GaitTiming& timing() const noexcept { return timing_; }

 private:
  static double fraction(double value) noexcept { return value - std::floor(value); }
  double phase_of(int leg) const noexcept;

  GaitTiming timing_;
  double phase_ = 0.0;                  // 0 .. 1
  std::array<bool, kLegs> grounded_{};  // the leg skips its swing
  std::array<bool, kLegs> waits_{};     // the leg should lift off, and waits for late feet
  double waited_ = 0.0;                 // [s] time for which the clock has waited
  double unloaded_ = 0.0;               // [s] time since the wait has ended
};

}  // namespace surefoot
