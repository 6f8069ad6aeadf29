// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "estimator/contact/contact_evidence.hpp"

namespace surefoot {

/// One foot's raw footForce: counts of unknown offset and scale, both of which drift.
///
/// counts = offset + scale load + noise. Where torques tell the load, offset and scale are the line
/// of least squares through recent pairs, the scale learnt only while the load changes. Where
/// nothing else tells, the range that the counts themselves have shown stands for the load, from
/// none at its bottom. A count that does not follow the load is left out. Real-time: yes.
class FootForceCalibration {
 public:
  /// @param load share of the weight by the torques, NAN if they are not to be had
  /// @param load_reliable may the load teach what the counts mean?
  ContactEvidence update(const Gains& gains, int count, double load, bool load_reliable,
                         bool loaded, double dt) noexcept;

  bool is_unchanged() const noexcept { return stuck_.is_unchanged(); }  ///< see StuckDetector
  double offset() const noexcept { return mean_count_ - scale_ * mean_load_; }  ///< [counts]
  double scale() const noexcept { return scale_; }  ///< [counts] per weight of the robot

 private:
  void update_fit(double count, double load, double dt) noexcept;
  SensorVerdict fit_verdict() const noexcept;
  void measure_noise(double count) noexcept;
  ContactEvidence range_evidence(const Gains& gains, double load, bool loaded) const noexcept;
  double load_by_range(double count, double dt) noexcept;

  StuckDetector stuck_;
  bool started_ = false;
  double last_count_ = 0.0;
  double noise_ = 0.0;  // [counts^2] of a sample
  double samples_ = 0.0;
  double smooth_count_ = 0.0, smooth_load_ = 0.0;
  double mean_count_ = 0.0, mean_load_ = 0.0;
  double fit_time_ = 0.0, spread_load_ = 0.0, spread_count_ = 0.0, covariance_ = 0.0;  // excited
  double scale_ = 0.0;
  double min_count_ = 0.0, max_count_ = 0.0;  // [counts]
};

}  // namespace surefoot
