// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace surefoot {

/// Reports a condition only after it has held for a minimum time. Real-time: yes.
class Debounce {
 public:
  /// Return whether `condition` has been true for `min_time` [s] without a break.
  /// @param dt [s] since the last call
  bool update(bool condition, double dt, double min_time) noexcept {
    time_ = condition ? time_ + dt : 0.0;
    return condition && time_ >= min_time - kRounding;
  }

 private:
  static constexpr double kRounding = 1e-9;  // [s] tolerance for the rounding of summed periods
  double time_ = 0.0;                        // [s] for which the condition has been true
};

}  // namespace surefoot
