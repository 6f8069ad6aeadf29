// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>

#include "surefoot/low_level.hpp"
#include "surefoot/math.hpp"

namespace surefoot {

/// Holds the robot's clock against its joints: over a while an angle changes by what its speed adds
/// up to in true time. Where most of the joints that move say that less time has passed than the
/// tick does, the clock is fast, and everything that goes by it, a rise above all, is too. A slow
/// one only makes the robot slow. Real-time: yes.
class ClockMonitor {
 public:
  static constexpr double kWindow = 0.06;     ///< [s] of the tick's time, compared at a time
  static constexpr int kWindows = 2;          ///< in a row
  static constexpr double kMinTravel = 0.01;  ///< [rad] by its speed: from here on a joint counts
  static constexpr double kFastRatio = 0.7;   ///< true time over the tick's below which it is fast
  static constexpr double kUnrelatedRatio =
      0.2;                                       ///< and above which the two have nothing in common
  static constexpr int kMinJoints = 4;           ///< that must move
  static constexpr double kMinLateShare = 0.75;  ///< share of them that must say so
  /// [rad/s] from one report to the next: such a speed is a blow, or lies, and its joint says
  /// nothing
  static constexpr double kMaxSpeedStep = 2.0;

  /// Judge a report. @param step [s] since the report before, by the tick
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
  /// Is the clock fast, by the last windows?
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
    // Who hardly moves says nothing, neither for nor against.
    if (moving < kMinJoints) return;
    late_windows_ = late >= kMinLateShare * moving ? late_windows_ + 1 : 0;
  }

  Vector12 q_start_ = Vector12::Zero(),
           travel_ = Vector12::Zero();     // [rad] at the window's begin; by dq
  Vector12 dq_ = Vector12::Zero();         // [rad/s] of the last report
  std::array<bool, kMotors> jolted_ = {};  // in the window
  double time_ = 0.0;                      // [s] of the window
  int late_windows_ = 0;                   // in a row that say so
  bool started_ = false;
};

}  // namespace surefoot
