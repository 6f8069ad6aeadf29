// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "estimator/contact/contact_evidence.hpp"

namespace surefoot {

/// Online calibration of one foot's footForce, whose offset and scale are unknown and drift.
///
/// The model is count = offset + scale load + noise. While another source measures the load, offset
/// and scale come from a least-squares line with exponential forgetting. The scale is updated only
/// while the load changes. Without another source, or until this fit is good, the load comes from
/// the observed range of counts: the smallest count is taken as zero load. If the counts do not
/// follow the load, the sensor has no vote. Real-time: yes.
class FootForceCalibration {
 public:
  /// Process one sample and return the evidence.
  /// @param count footForce of the foot
  /// @param load load from another source, as a share of the weight; NaN if there is no other
  ///   source
  /// @param load_reliable true if the load may be used for calibration
  /// @param loaded present contact state of the foot, used for hysteresis
  ContactEvidence update(const Gains& gains, int count, double load, bool load_reliable,
                         bool loaded, double dt) noexcept;

  bool is_unchanged() const noexcept { return stuck_.is_unchanged(); }  ///< see StuckDetector
  double offset() const noexcept { return mean_count_ - scale_ * mean_load_; }  ///< [counts]
  double scale() const noexcept { return scale_; }  ///< [counts] per load of one robot weight

 private:
  void update_fit(double count, double load, double dt) noexcept;
  SensorVerdict fit_verdict() const noexcept;
  void measure_noise(double count) noexcept;
  ContactEvidence range_evidence(const Gains& gains, double load, bool loaded) const noexcept;
  double load_by_range(double count, double dt) noexcept;

  StuckDetector stuck_;
  bool started_ = false;
  double last_count_ = 0.0;
  double noise_ = 0.0;                             // [counts^2] variance of the noise of one sample
  double samples_ = 0.0;                           // number of samples in noise_
  double smooth_count_ = 0.0, smooth_load_ = 0.0;  // low-passed with kFilterTime
  double mean_count_ = 0.0, mean_load_ = 0.0;      // low-passed with kOffsetTime
  // Sums of the fit over the time of changing load [s]: time; squared deviations of load and of
  // counts from their means; product of both deviations.
  double fit_time_ = 0.0, spread_load_ = 0.0, spread_count_ = 0.0, covariance_ = 0.0;
  double scale_ = 0.0;
  double min_count_ = 0.0, max_count_ = 0.0;  // [counts] observed range
};

}  // namespace surefoot
