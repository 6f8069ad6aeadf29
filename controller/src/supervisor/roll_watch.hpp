// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "supervisor/lean.hpp"

namespace surefoot {

/// Does a lying body roll over the legs that fold under it? It is let go of then, while it may
/// still fall back, twice. One that goes over all the same rolls on: they are not where they are
/// thought to be, or something else is in the way. Real-time: yes.
class RollWatch {
 public:
  /// @param up the world's vertical, in base axes
  void start(const Vector3& up) noexcept {
    *this = {};
    first_ = lean(up);
  }
  /// @param up the world's vertical, in base axes @param dt [s]
  void update(const Vector3& up, double dt) noexcept {
    const double now = lean(up);
    const bool again = rolls_ == kTries && !lets_go() && std::abs(sideways(up)) > kAgain;
    rolls_on_ = rolls_on_ || again || (rolls_ > 0 && now > kTooFar);
    if (lets_go()) {
      left_ -= dt;
      if (!lets_go()) first_ = now;  // as it lies now
      return;
    }
    if (rolls_ == kTries || !(now > kFar && now > first_ + kMore)) return;
    ++rolls_;
    left_ = kRest;
  }
  int rolls() const noexcept { return rolls_; }          ///< so far
  bool lets_go() const noexcept { return left_ > 0.0; }  ///< of the legs, for now
  bool rolls_on() const noexcept { return rolls_on_; }

 private:
  static constexpr double kFar = 0.44;     // [rad] 25 degrees: most that a robot is armed at ...
  static constexpr double kMore = 0.12;    // [rad] ... and no lean that was there before
  static constexpr double kRest = 1.0;     // [s] until it lies again
  static constexpr double kTooFar = 0.74;  // [rad] healthy ones fall back from 0.7, let go of ...
  // [rad] ... and are not this far on one side again after two rolls. They pitch as far, propped
  // up by a front leg that is caught below them, and come down when it comes free.
  static constexpr double kAgain = 0.69;
  static constexpr int kTries = 2;

  double first_ = 0.0;  // [rad] lean as it lay
  int rolls_ = 0;
  bool rolls_on_ = false;
  double left_ = 0.0;  // [s]
};

}  // namespace surefoot
