// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "surefoot/math.hpp"

namespace surefoot {

/// White noise of a sensor's samples, measured while it is used.
///
/// Second differences pass little of what the body does and all of the noise, six times:
/// E|x_k - 2 x_{k-1} + x_{k-2}|^2 = 6 sigma^2 an axis. Vibration counts as noise, which for a
/// filter it is. Real-time: yes.
class SampleNoise {
 public:
  /// @param sigma first guess, of one axis; what is measured stays within a quarter and ten times
  /// it
  void reset(double sigma) noexcept {
    prior_sigma_ = sigma;
    variance_ = sigma * sigma;
    count_ = 0;
  }

  /// @param value a fresh sample, not a held one
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
  static constexpr double kTimeConstant = 0.5;   // [s]
  static constexpr double kPriorSamples = 20.0;  // samples that the first guess is worth
  static constexpr double kOutlierRatio = 25.0;  // a blow is not noise
  static constexpr double kMinRatio = 0.25;  // of the guess: no sensor is that good while it moves
  static constexpr double kMaxRatio = 10.0;
  static constexpr int kMaxCount = 1 << 20;
  double prior_sigma_ = 1.0, variance_ = 1.0;
  int count_ = 0;
  Vector3 last_ = Vector3::Zero(), second_last_ = Vector3::Zero();
};

}  // namespace surefoot
