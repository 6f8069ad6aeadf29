// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/estimator_report.hpp"
#include "surefoot/gains.hpp"

namespace surefoot {

/// What one source says of one foot's contact.
struct Evidence {
  double says = 0.0;  ///< -1 off the ground .. 1 loaded; 0 nothing
  Verdict verdict = Verdict::kUnjudged;
};

/// How a load, as a share of the robot's weight, speaks for contact. Real-time: yes.
/// @param loaded what is believed so far: the threshold has hysteresis
/// @param doubt of the load, a share of the weight, one standard deviation
double say_load(const Gains& gains, double load, double doubt, bool loaded) noexcept;

/// An integer sensor that may stand still: zero, stuck, or at the end of its range.
///
/// Standing still is no fault while nothing happens; it is once the load has moved by kMoved of the
/// weight meanwhile, by what the torques say. Real-time: yes.
class StuckDetector {
 public:
  /// @param load share of the weight by another source, NAN if there is none
  Verdict see(int value, double load, double dt) noexcept;
  /// Has it read the same for longer than a live sensor's noise lets it?
  bool still() const noexcept { return held_ > kStill; }

 private:
  static constexpr double kStill = 0.003;  // [s]
  int last_ = 0;
  bool started_ = false, ever_ = false;
  double held_ = 0.0, least_ = 0.0, most_ = 0.0;
};

}  // namespace surefoot
