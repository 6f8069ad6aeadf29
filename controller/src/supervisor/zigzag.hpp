// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

namespace surefoot {

/// How much a signal goes to and fro from one sample to the next: the mean of minus the product of
/// neighbouring changes, the smaller of two such products in a row. Positive for what alternates,
/// negative for what moves smoothly, about zero for steps and for single wrong samples, that go and
/// come back once. Real-time: yes.
class Zigzag {
 public:
  /// @param share of this sample in the mean @return the mean, in the value's unit squared
  double update(double value, double share) noexcept {
    const double change = started_ ? value - value_ : 0.0;
    const double product = -change * change_;
    mean_ += share * (std::min(product, product_) - mean_);
    value_ = value;
    change_ = change;
    product_ = product;
    started_ = true;
    return mean_;
  }

  /// What comes next is not to be compared with what came last.
  void interrupt() noexcept {
    started_ = false;
    change_ = product_ = 0.0;
  }

 private:
  double value_ = 0.0, change_ = 0.0, product_ = 0.0, mean_ = 0.0;
  bool started_ = false;
};

}  // namespace surefoot
