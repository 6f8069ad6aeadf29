// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>

#include "surefoot/low_level.hpp"
#include "surefoot/math.hpp"

namespace surefoot {

/// Detects a robot clock (LowState::tick) that is too fast, by comparison with the joints.
///
/// For each joint and window, ratio = (change of q) / (sum of dq times the step of the tick), which
/// is the true time divided by the tick's time. The clock is too fast if most moving joints have a
/// ratio below kFastRatio in kWindows consecutive windows. A clock that is too fast speeds up every
/// timed motion, above all a rise. A slow clock only makes the robot slow and is not detected.
/// Real-time: yes.
class ClockMonitor {
 public:
  // All chosen by hand; tests: clock_at_twice_the_rate_is_detected_within_200_ms,
  // correct_or_slow_clock_and_wrong_speeds_raise_no_fault.
  /// [s] Length of a window, measured by the tick. If smaller: joints move too little in a window.
  /// If larger: two windows and the wait for motion exceed the 0.2 s of fault_table().
  static constexpr double kWindow = 0.06;
  static constexpr int kWindows = 2;  ///< consecutive windows needed; one window may hold an impact
  /// [rad] Displacement (sum of dq times step) in a window from which a joint counts as moving. 18
  /// standard deviations of the simulated encoder noise (0.05 rad/s, 30 samples of 2 ms).
  static constexpr double kMinTravel = 0.01;
  /// Ratio below which the clock is too fast. Between a correct clock (1) and twice the rate (0.5).
  static constexpr double kFastRatio = 0.7;
  static constexpr double kUnrelatedRatio = 0.2;  ///< Ratio below which dq is wrong, not the clock.
  /// Moving joints needed for a verdict: more than one leg has.
  static constexpr int kMinJoints = 4;
  /// Share of the moving joints that must have such a ratio.
  static constexpr double kMinLateShare = 0.75;
  /// [rad/s] Change of dq between two samples above which an impact or a sensor error is assumed.
  /// The joint then does not count in that window. Must be below the wrong samples of 5 rad/s in
  /// the row power_trip.
  static constexpr double kMaxSpeedStep = 2.0;

  /// Judge a sample. @param step [s] since the previous sample, by the tick
  void update(const LowState& state, double step) noexcept {
    time_ += step;
    Vector12 q;
    for (int i = 0; i < kMotors; ++i) {
      q[i] = state.motorState[i].q;
      const double dq = state.motorState[i].dq;
      travel_[i] += dq * step;
      jolted_[i] = jolted_[i] || std::abs(dq - dq_[i]) > kMaxSpeedStep;
      dq_[i] = dq;
    }
    if (started_ && time_ < kWindow) return;
    if (started_) judge((q - q_start_).eval());
    q_start_ = q;
    travel_.setZero();
    jolted_ = {};
    time_ = 0.0;
    started_ = true;
  }
  /// Return whether the clock was too fast in the last kWindows windows.
  bool fast() const noexcept { return late_windows_ >= kWindows; }

 private:
  void judge(const Vector12& angle_change) noexcept {
    int moving = 0, late = 0;
    for (int i = 0; i < kMotors; ++i) {
      if (std::abs(travel_[i]) < kMinTravel || jolted_[i]) continue;
      const double share = angle_change[i] / travel_[i];
      ++moving;
      late += share > kUnrelatedRatio && share < kFastRatio;
    }
    // Too few joints move for a verdict: keep the last one.
    if (moving < kMinJoints) return;
    late_windows_ = late >= kMinLateShare * moving ? late_windows_ + 1 : 0;
  }

  // [rad] q at the start of the window; displacement since then, from dq
  Vector12 q_start_ = Vector12::Zero(), travel_ = Vector12::Zero();
  Vector12 dq_ = Vector12::Zero();         // [rad/s] of the last sample
  std::array<bool, kMotors> jolted_ = {};  // dq jumped in this window
  double time_ = 0.0;                      // [s] since the start of the window
  int late_windows_ = 0;                   // consecutive windows with a fast clock
  bool started_ = false;
};

}  // namespace surefoot
