// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

namespace surefoot {

/// Does a lying body roll over the legs that fold under it? It is let go of then, while it may
/// still fall back, twice. One that goes over all the same rolls on: they are not where they are
/// thought to be, or something else is in the way. Real-time: yes.
class RollWatch {
 public:
  void start(double lean) noexcept {
    *this = {};
    first_ = lean;
  }
  /// @param lean of the body's vertical [rad] @param sideways the part of it that is roll [rad],
  /// either sign @param dt [s]
  void update(double lean, double sideways, double dt) noexcept {
    const bool again = rolls_ == kTries && !lets_go() && std::abs(sideways) > kAgain;
    rolls_on_ = rolls_on_ || again || (rolls_ > 0 && lean > kTooFar);
    if (lets_go()) {
      left_ -= dt;
      if (!lets_go()) first_ = lean;  // as it lies now
      return;
    }
    if (rolls_ == kTries || !(lean > kFar && lean > first_ + kMore)) return;
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
  // [rad] ... and are not this far on one side again after two rolls. They pitch as far, on the
  // thighs of one end, and come down when the other's have folded.
  static constexpr double kAgain = 0.69;
  static constexpr int kTries = 2;

  double first_ = 0.0;  // [rad]
  int rolls_ = 0;
  bool rolls_on_ = false;
  double left_ = 0.0;  // [s]
};

}  // namespace surefoot
