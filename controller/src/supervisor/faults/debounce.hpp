// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace surefoot {

/// Reports a condition only after the condition has been true for a minimum time. Real-time: yes.
class Debounce {
 public:
  /// Return whether `condition` has been true for `min_time` [s] without interruption.
  /// @param dt [s] time since the last call
  bool update(bool condition, double dt, double min_time) noexcept {
    time_ = condition ? time_ + dt : 0.0;
    return condition && time_ >= min_time - kRounding;
  }

 private:
  static constexpr double kRounding = 1e-9;  // [s] tolerance for rounding of summed periods
  double time_ = 0.0;                        // [s] time for which the condition has been true
};

}  // namespace surefoot
