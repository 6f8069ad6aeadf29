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
    guess_ = sigma;
    variance_ = sigma * sigma;
    count_ = 0;
  }

  /// @param value a fresh sample, not a held one
  void update(const Vector3& value, double dt) noexcept {
    if (count_ >= 2) {
      const double found = (value - 2.0 * last_ + before_).squaredNorm() / 18.0;
      const double blend = std::max(dt / (dt + kTime), 1.0 / (kGuess + count_));
      variance_ += blend * (std::min(found, kWild * variance_) - variance_);
    }
    before_ = last_;
    last_ = value;
    count_ = std::min(count_ + 1, kMost);
  }

  double sigma() const noexcept {
    return std::clamp(std::sqrt(variance_), guess_ * kLeast, guess_ * kMostTimes);
  }

 private:
  static constexpr double kTime = 0.5;    // [s]
  static constexpr double kGuess = 20.0;  // samples that the first guess is worth
  static constexpr double kWild = 25.0;   // a blow is not noise
  static constexpr double kLeast = 0.25;  // of the guess: no sensor is that good while it moves
  static constexpr double kMostTimes = 10.0;
  static constexpr int kMost = 1 << 20;
  double guess_ = 1.0, variance_ = 1.0;
  int count_ = 0;
  Vector3 last_ = Vector3::Zero(), before_ = Vector3::Zero();
};

}  // namespace surefoot
