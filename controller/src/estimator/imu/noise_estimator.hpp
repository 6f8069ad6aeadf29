// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "surefoot/math.hpp"

namespace surefoot {

/// Online estimate of the white noise of a three-axis sensor.
///
/// Second differences of the samples contain little body motion. On each axis, their mean square is
/// six times the noise variance: E|x_k - 2 x_{k-1} + x_{k-2}|^2 = 6 sigma^2. Vibration counts as
/// noise, as the filter requires. Real-time: yes.
class NoiseEstimator {
 public:
  /// Start again with an initial value.
  /// @param sigma standard deviation of one axis; estimates stay within 0.25 sigma .. 10 sigma
  void reset(double sigma) noexcept {
    prior_sigma_ = sigma;
    variance_ = sigma * sigma;
    count_ = 0;
  }

  /// Process one measurement.
  /// @param value new measurement; the caller must not pass repeated values
  void update(const Vector3& value, double dt) noexcept {
    if (count_ >= 2) {
      const double sample_variance = (value - 2.0 * last_ + second_last_).squaredNorm() / 18.0;
      const double blend = std::max(dt / (dt + kTimeConstant), 1.0 / (kPriorSamples + count_));
      variance_ += blend * (std::min(sample_variance, kOutlierRatio * variance_) - variance_);
    }
    second_last_ = last_;
    last_ = value;
    count_ = std::min(count_ + 1, kMaxCount);
  }

  double sigma() const noexcept {
    return std::clamp(std::sqrt(variance_), prior_sigma_ * kMinRatio, prior_sigma_ * kMaxRatio);
  }

 private:
  // [s] Time constant of the average. Chosen. If smaller: the average contains too few samples; an
  // accuracy of 10 % needs some hundred samples. If larger: the estimate follows changes of the
  // noise, for example vibration, too late. Test:
  // sample_noise_is_estimated_within_10_percent_during_motion.
  static constexpr double kTimeConstant = 0.5;
  static constexpr double kPriorSamples = 20.0;  // [samples] weight of the initial value; chosen
  // Largest variance of one sample, as a multiple of the estimate; larger values, from impacts,
  // count as this limit. Derived: the square of five standard deviations.
  static constexpr double kOutlierRatio = 25.0;
  // Bounds of the estimate, as multiples of the initial sigma. Chosen: the noise of no real sensor
  // is further from the gains noise_gyroscope and noise_accelerometer
  // (docs/explanation/estimator.md).
  static constexpr double kMinRatio = 0.25;
  static constexpr double kMaxRatio = 10.0;
  static constexpr int kMaxCount = 1 << 20;  // avoids overflow; `blend` is constant long before
  double prior_sigma_ = 1.0, variance_ = 1.0;
  int count_ = 0;
  Vector3 last_ = Vector3::Zero(), second_last_ = Vector3::Zero();
};

}  // namespace surefoot
