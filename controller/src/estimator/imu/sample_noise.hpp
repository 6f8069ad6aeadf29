// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "surefoot/math.hpp"

namespace surefoot {

/// Online estimate of the white noise of a three-axis sensor.
///
/// Second differences contain little body motion and six times the noise variance: per axis,
/// E|x_k - 2 x_{k-1} + x_{k-2}|^2 = 6 sigma^2. Vibration counts as noise, as it should for a
/// filter. Real-time: yes.
class SampleNoise {
 public:
  /// Start again.
  /// @param sigma initial standard deviation of one axis; estimates stay within 1/4 .. 10 times it
  void reset(double sigma) noexcept {
    prior_sigma_ = sigma;
    variance_ = sigma * sigma;
    count_ = 0;
  }

  /// Process one sample.
  /// @param value new measurement; held samples must not be passed
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
  // [s] averaging. Chosen. Below: some hundred samples for 10 %; above: noise changes, e.g.
  // vibration. Test sample_noise_is_estimated_within_10_percent_during_motion.
  static constexpr double kTimeConstant = 0.5;
  static constexpr double kPriorSamples = 20.0;  // [samples] weight of the initial value; chosen
  // Clips larger sample variances: impacts. Derived: the square of five standard deviations.
  static constexpr double kOutlierRatio = 25.0;
  // Bounds, as shares of the initial sigma. Chosen: a real sensor is at most so much better or
  // worse than noise_gyroscope and noise_accelerometer (docs/estimation.md).
  static constexpr double kMinRatio = 0.25;
  static constexpr double kMaxRatio = 10.0;
  static constexpr int kMaxCount = 1 << 20;  // against overflow; the blend is constant long before
  double prior_sigma_ = 1.0, variance_ = 1.0;
  int count_ = 0;
  Vector3 last_ = Vector3::Zero(), second_last_ = Vector3::Zero();
};

}  // namespace surefoot
