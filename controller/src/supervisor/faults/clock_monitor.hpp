// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>

#include "surefoot/low_level.hpp"
#include "surefoot/math.hpp"

namespace surefoot {

/// Detects a robot clock (LowState::tick) that runs too fast or too slow, by comparing the clock
/// with the motion of the joints.
///
/// In each time window, each joint gives the ratio (change of q) / (sum of dq times the step of the
/// tick). This ratio is the true time divided by the time that the tick counts. The clock is too
/// fast if most moving joints have a ratio below kFastRatio in kWindows consecutive windows. With a
/// fast clock, the controller moves its references too fast, most of all in a rise. The clock is
/// too slow if the ratios are above kSlowRatio. A slow clock only makes a stand or a rise slow, but
/// a robot whose feet step falls. Real-time: yes.
class ClockMonitor {
 public:
  // The constants are chosen by hand. Tests: clock_at_twice_the_rate_is_detected_within_200_ms,
  // correct_or_slow_clock_and_wrong_speeds_raise_no_fault.
  /// [s] Length of a window, measured by the tick. If shorter: joints move too little in a window.
  /// If longer: two windows and the wait for motion exceed the 0.2 s of fault_table().
  static constexpr double kWindow = 0.06;
  /// Number of consecutive windows needed, because one window may contain an impact.
  static constexpr int kWindows = 2;
  /// [rad] A joint counts as moving if its displacement in a window (sum of dq times step) is at
  /// least this. Simulated encoder noise (0.05 rad/s, 30 samples of 2 ms) causes a displacement
  /// with a standard deviation of 0.0005 rad.
  static constexpr double kMinDisplacement = 0.01;
  /// Ratio below which the clock is too fast: between a correct clock (1) and twice the rate (0.5).
  static constexpr double kFastRatio = 0.7;
  /// Ratio above which the clock is too slow: the inverse of kFastRatio.
  static constexpr double kSlowRatio = 1.0 / kFastRatio;
  /// Ratio below which, or above the inverse of which, the joint's dq must be wrong; such a joint
  /// is no evidence of a wrong clock.
  static constexpr double kUnrelatedRatio = 0.2;
  /// Number of moving joints that a verdict needs: one more than the number of joints of a leg.
  static constexpr int kMinJoints = 4;
  /// Share of the moving joints whose ratio must show a wrong clock.
  static constexpr double kMinShare = 0.75;
  /// [rad/s] Change of dq between two samples above which an impact or a sensor error is assumed.
  /// The joint is then not counted in this window. Smaller than 5 rad/s, the wrong velocities in
  /// the row power_trip of `surefoot faults`.
  static constexpr double kMaxSpeedStep = 2.0;

  /// Process a sample. @param step [s] time since the previous sample, measured by the tick
  void update(const LowState& state, double step) noexcept {
    time_ += step;
    Vector12 q;
    for (int i = 0; i < kMotors; ++i) {
      q[i] = state.motorState[i].q;
      const double dq = state.motorState[i].dq;
      displacement_[i] += dq * step;
      jumped_[i] = jumped_[i] || std::abs(dq - dq_[i]) > kMaxSpeedStep;
      dq_[i] = dq;
    }
    if (started_ && time_ < kWindow) return;
    if (started_) judge((q - q_start_).eval());
    q_start_ = q;
    displacement_.setZero();
    jumped_ = {};
    time_ = 0.0;
    started_ = true;
  }
  /// Return whether the clock was too fast in the last kWindows windows with enough motion.
  bool fast() const noexcept { return fast_windows_ >= kWindows; }
  /// Forget how often the clock was too slow.
  void reset_slow() noexcept { slow_windows_ = 0; }
  /// The same for a clock that was too slow.
  bool slow() const noexcept { return slow_windows_ >= kWindows; }

 private:
  void judge(const Vector12& angle_change) noexcept {
    int moving = 0, fast_joints = 0, slow_joints = 0;
    for (int i = 0; i < kMotors; ++i) {
      if (std::abs(displacement_[i]) < kMinDisplacement || jumped_[i]) continue;
      const double ratio = angle_change[i] / displacement_[i];
      ++moving;
      fast_joints += ratio > kUnrelatedRatio && ratio < kFastRatio;
      slow_joints += ratio > kSlowRatio && ratio < 1.0 / kUnrelatedRatio;
    }
    // Too few joints move for a verdict: keep the last verdict.
    if (moving < kMinJoints) return;
    fast_windows_ = fast_joints >= kMinShare * moving ? fast_windows_ + 1 : 0;
    slow_windows_ = slow_joints >= kMinShare * moving ? slow_windows_ + 1 : 0;
  }

  // [rad] q_start_: q at the start of the window. displacement_: displacement since then, computed
  // from dq.
  Vector12 q_start_ = Vector12::Zero(), displacement_ = Vector12::Zero();
  Vector12 dq_ = Vector12::Zero();         // [rad/s] velocities of the last sample
  std::array<bool, kMotors> jumped_ = {};  // true for each joint whose dq jumped in this window
  double time_ = 0.0;                      // [s] time since the start of the window
  int fast_windows_ = 0;                   // number of consecutive windows with a fast clock
  int slow_windows_ = 0;                   // the same with a slow clock
  bool started_ = false;
};

}  // namespace surefoot
