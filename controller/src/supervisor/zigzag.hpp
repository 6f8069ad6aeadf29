// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

namespace surefoot {

/// How much a signal goes to and fro from one sample to the next: the mean of minus the product of
/// neighbouring changes. Positive for what alternates and for white noise (its variance), negative
/// for what moves smoothly, zero for steps that come now and then, and for single wrong samples:
/// what goes and comes back must do so in three samples of ten. Real-time: yes.
class Zigzag {
 public:
  /// @param share of this sample in the mean @return the mean, in the value's unit squared
  double update(double value, double share) noexcept {
    const double change = started_ ? value - value_ : 0.0;
    const double product = -change * change_;
    // Of the products that make the mean, not of the noise between them.
    const bool counts = product > 0.5 * std::max(mean_, 0.0);
    often_ += share * ((counts ? 1.0 : 0.0) - often_);
    mean_ += share * (product - mean_);
    value_ = value;
    change_ = change;
    started_ = true;
    return often_ > kOften ? mean_ : std::min(mean_, 0.0);
  }

  /// What comes next is not to be compared with what came last.
  void interrupt() noexcept {
    started_ = false;
    change_ = 0.0;
  }

 private:
  static constexpr double kOften = 0.3;
  double value_ = 0.0, change_ = 0.0, mean_ = 0.0, often_ = 0.0;
  bool started_ = false;
};

}  // namespace surefoot
