// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace surefoot {

/// Does a lying body roll over the legs that fold under it? It is let go of then, once in a rise,
/// while it may still fall back: what rolls on is the fault `tilt`. Real-time: yes.
class RollWatch {
 public:
  void start(double lean) noexcept {
    *this = {};
    first_ = lean;
  }
  /// @param lean of the body's vertical [rad] @param dt [s]
  void update(double lean, double dt) noexcept {
    left_ -= dt;
    if (rolled_ || !(lean > kFar && lean > first_ + kMore)) return;
    rolled_ = true;
    left_ = kRest;
  }
  bool rolled() const noexcept { return rolled_; }
  bool lets_go() const noexcept { return left_ > 0.0; }  ///< of the legs, for now

 private:
  static constexpr double kFar = 0.44;   // [rad] 25 degrees: most that a robot is armed at ...
  static constexpr double kMore = 0.12;  // [rad] ... and no lean that was there before
  static constexpr double kRest = 1.0;   // [s] until it lies again

  double first_ = 0.0;  // [rad]
  bool rolled_ = false;
  double left_ = 0.0;  // [s]
};

}  // namespace surefoot
