// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace surefoot {

/// What has lasted, as opposed to what flickers. Real-time: yes.
class Debounce {
 public:
  /// Has `condition` been true for `min_time` [s] without a break?
  bool update(bool condition, double dt, double min_time) noexcept {
    time_ = condition ? time_ + dt : 0.0;
    return condition && time_ >= min_time - kRounding;
  }

 private:
  static constexpr double kRounding = 1e-9;  // [s]
  double time_ = 0.0;                        // [s]
};

}  // namespace surefoot
