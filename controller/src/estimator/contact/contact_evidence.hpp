// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/estimator_report.hpp"
#include "surefoot/gains.hpp"

namespace surefoot {

/// Evidence of one contact source for one foot.
struct ContactEvidence {
  double vote = 0.0;  ///< -1 off the ground .. 1 loaded; 0: no evidence
  SensorVerdict verdict = SensorVerdict::kUnjudged;
};

/// Convert a load to a vote: tanh((load - threshold) / max(width, load_sigma)). Real-time: yes.
/// @param load normal force, share of the robot's weight
/// @param load_sigma standard deviation of load
/// @param loaded present contact state, which selects the threshold (hysteresis)
double load_vote(const Gains& gains, double load, double load_sigma, bool loaded) noexcept;

/// Detects an integer sensor that is zero, stuck, or at the end of its range.
///
/// A constant value is no fault while the load is constant. It is a fault once another source has
/// shown a load change of more than 10 % of the weight meanwhile. Real-time: yes.
class StuckDetector {
 public:
  /// Process one sample and return the verdict.
  /// @param load share of the weight by another source, NaN if there is none
  SensorVerdict update(int value, double load, double dt) noexcept;
  /// Return whether the value has been constant for longer than a working sensor's noise allows.
  bool is_unchanged() const noexcept { return unchanged_time_ > kMinUnchangedTime; }

 private:
  // [s] See is_unchanged(). Chosen: more than one period at 500 Hz, less than two; a working
  // sensor's noise changes every sample.
  static constexpr double kMinUnchangedTime = 0.003;
  int last_ = 0;
  bool started_ = false, ever_nonzero_ = false;
  double unchanged_time_ = 0.0, min_load_ = 0.0, max_load_ = 0.0;
};

}  // namespace surefoot
