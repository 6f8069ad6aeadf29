// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/estimator_report.hpp"
#include "surefoot/gains.hpp"

namespace surefoot {

/// What one source says of one foot's contact.
struct ContactEvidence {
  double vote = 0.0;  ///< -1 off the ground .. 1 loaded; 0 nothing
  SensorVerdict verdict = SensorVerdict::kUnjudged;
};

/// How a load, as a share of the robot's weight, speaks for contact. Real-time: yes.
/// @param loaded what is believed so far: the threshold has hysteresis
/// @param load_sigma of the load, a share of the weight, one standard deviation
double load_vote(const Gains& gains, double load, double load_sigma, bool loaded) noexcept;

/// An integer sensor that may stand still: zero, stuck, or at the end of its range.
///
/// Standing still is no fault while nothing happens; it is once the load has moved by
/// kMinLoadChange of the weight meanwhile, by what the torques say. Real-time: yes.
class StuckDetector {
 public:
  /// @param load share of the weight by another source, NAN if there is none
  SensorVerdict update(int value, double load, double dt) noexcept;
  /// Has it read the same for longer than a live sensor's noise lets it?
  bool is_unchanged() const noexcept { return unchanged_time_ > kMinUnchangedTime; }

 private:
  static constexpr double kMinUnchangedTime = 0.003;  // [s]
  int last_ = 0;
  bool started_ = false, ever_nonzero_ = false;
  double unchanged_time_ = 0.0, min_load_ = 0.0, max_load_ = 0.0;
};

}  // namespace surefoot
