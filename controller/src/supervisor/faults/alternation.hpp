// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

namespace surefoot {

/// Measures how much a signal alternates from one sample to the next.
///
/// The measure is the running mean of -d[k] d[k-1], where d[k] is the change of the signal at
/// sample k. The measure is positive for an alternating signal, negative for a smooth signal, and
/// zero for isolated steps. For white noise it equals the variance of the noise. Real-time: yes.
class Alternation {
 public:
  /// Add a sample.
  /// @param share weight of this sample in the mean, 0 .. 1
  /// @param value present value of the signal
  /// @param min_change [unit of value] smaller alternations do not count in is_frequent()
  /// @return the mean [unit of value squared]
  double update(double value, double share, double min_change = 0.0) noexcept {
    const double change = started_ ? value - value_ : 0.0;
    const double product = -change * change_;
    // Count only alternations of more than half of the mean, not the noise between them.
    const bool is_large = product > std::max(0.5 * mean_, min_change * min_change);
    frequency_ += share * ((is_large ? 1.0 : 0.0) - frequency_);
    mean_ += share * (product - mean_);
    value_ = value;
    change_ = change;
    started_ = true;
    return mean_;
  }

  /// Return whether the signal alternates in more than 30 % of the samples. A single wrong sample
  /// counts as one alternation, because the signal jumps and returns. One wrong sample in ten must
  /// not make the result true, but one in three must. Chosen; test:
  /// one_wrong_sample_in_ten_is_not_frequent.
  bool is_frequent() const noexcept { return frequency_ > 0.3; }

  /// Do not compare the next sample with the last sample. The means are kept.
  void interrupt() noexcept {
    started_ = false;
    change_ = 0.0;
  }

 private:
  double value_ = 0.0, change_ = 0.0, mean_ = 0.0, frequency_ = 0.0;
  bool started_ = false;
};

}  // namespace surefoot
