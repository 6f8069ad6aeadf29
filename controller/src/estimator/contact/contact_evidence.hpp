// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/estimator_report.hpp"
#include "surefoot/gains.hpp"

namespace surefoot {

/// Evidence for or against contact, from one contact source for one foot.
struct ContactEvidence {
  double vote = 0.0;  ///< -1: off the ground, 1: loaded, 0: no evidence
  SensorVerdict verdict = SensorVerdict::kUnjudged;
};

/// Convert a load to a vote, -1 .. 1: tanh((load - threshold) / max(width, load_sigma)). Threshold
/// and width are the gains contact_force_*. Real-time: yes.
/// @param load normal force of the foot, as a share of the robot's weight
/// @param load_sigma uncertainty of `load`: 0, or two standard deviations of its noise
/// @param loaded present contact state; it selects the threshold contact_force_off (true) or
///   contact_force_on (false), for hysteresis
double load_vote(const Gains& gains, double load, double load_sigma, bool loaded) noexcept;

/// Detects an integer sensor that is zero, stuck, or at the end of its range.
///
/// A constant value is a fault only if another source has shown a load change of more than 10 % of
/// the weight in the meantime. Real-time: yes.
class StuckDetector {
 public:
  /// Process one sample and return the verdict.
  /// @param load load from another source, as a share of the weight; NaN if there is no other
  ///   source
  SensorVerdict update(int value, double load, double dt) noexcept;
  /// Return whether the value has been constant for longer than that of a working sensor, whose
  /// noise changes the value.
  bool is_unchanged() const noexcept { return unchanged_time_ > kMinUnchangedTime; }

 private:
  // [s] Time limit of is_unchanged(). Chosen: two repeated samples at 500 Hz (4 ms) exceed it.
  // Noise changes the value of a working sensor more often.
  static constexpr double kMinUnchangedTime = 0.003;
  int last_ = 0;
  bool started_ = false, ever_nonzero_ = false;
  double unchanged_time_ = 0.0, min_load_ = 0.0, max_load_ = 0.0;
};

}  // namespace surefoot
