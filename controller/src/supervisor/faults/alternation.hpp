// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

namespace surefoot {

/// How much a signal goes to and fro from one sample to the next: the mean of minus the product of
/// neighbouring changes. Positive for what alternates and for white noise (its variance), negative
/// for what moves smoothly, zero for steps that come now and then. Real-time: yes.
class Alternation {
 public:
  /// @param share of this sample in the mean @param min_change in the value's unit: smaller ways to
  /// and fro do not count for is_frequent() @return the mean, in the value's unit squared
  double update(double value, double share, double min_change = 0.0) noexcept {
    const double change = started_ ? value - value_ : 0.0;
    const double product = -change * change_;
    // The ways that make the mean, not the noise between them.
    const bool counts = product > std::max(0.5 * mean_, min_change * min_change);
    frequency_ += share * ((counts ? 1.0 : 0.0) - frequency_);
    mean_ += share * (product - mean_);
    value_ = value;
    change_ = change;
    started_ = true;
    return mean_;
  }

  /// Does it do so in three samples of ten? A wrong sample in ten goes and comes back, too.
  bool is_frequent() const noexcept { return frequency_ > 0.3; }

  /// What comes next is not to be compared with what came last.
  void interrupt() noexcept {
    started_ = false;
    change_ = 0.0;
  }

 private:
  double value_ = 0.0, change_ = 0.0, mean_ = 0.0, frequency_ = 0.0;
  bool started_ = false;
};

}  // namespace surefoot
