// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>

#include "surefoot/low_level.hpp"
#include "surefoot/math.hpp"

namespace surefoot {

/// Who folds first of a lying robot's legs. A body that leans is propped up, and its legs keep it
/// from rolling over: a diagonal pair stays where it is until the other is folded and does so. It
/// is the pair with the front leg that props the lower side: the one of that side, or, where that
/// one is drawn in under the body, the other, unless its knee is up. A rear leg that is drawn in,
/// its knee down, turns the body over once the others are folded: its pair does not wait, unless
/// that holds for both. Only for a while, for legs may interlace; and bodies with a wide belly need
/// it not. Real-time: yes.
class FoldingOrder {
 public:
  struct Leg {
    double inward = 0.0;  ///< of its hip [rad]
    double thigh = 0.0;   ///< [rad] the way that it folds
  };
  /// @param up the world's vertical, in base axes
  /// @param legs FR, FL, RR, RL
  /// @param always take turns, even where it is level @param wait [s]; 0: nobody waits
  void start(const Vector3& up, const std::array<Leg, kLegs>& legs, bool always,
             double wait) noexcept {
    time_left_ = always || std::hypot(up.x(), up.y()) > kMinTilt ? wait : 0.0;
    const int lower = up.y() > 0.0 ? FR_ : FL_;
    const bool crossed = legs[lower].inward > kHipInward && legs[1 - lower].thigh < kKneeUp;
    waiting_front_leg_ = crossed ? 1 - lower : lower;
    const auto turns_over = [&](int front) {
      const Leg& rear = legs[diagonal_leg(front)];
      return rear.inward > kHipInward && rear.thigh < kKneeUp;
    };
    if (turns_over(waiting_front_leg_) && !turns_over(1 - waiting_front_leg_))
      waiting_front_leg_ = 1 - waiting_front_leg_;
  }
  /// @param others_folded are those that do not wait folded?
  void update(bool others_folded, double dt) noexcept {
    time_left_ = others_folded ? 0.0 : time_left_ - dt;
  }
  bool waits(int leg) const noexcept {
    return time_left_ > 0.0 &&
           (leg == waiting_front_leg_ || leg == diagonal_leg(waiting_front_leg_));
  }

 private:
  static constexpr double kMinTilt = 0.2;    // sine of 11.5 degrees: something is under the body
  static constexpr double kHipInward = 0.5;  // [rad]
  static constexpr double kKneeUp = 2.2;     // [rad]

  double time_left_ = 0.0;       // [s] that a pair may still wait
  int waiting_front_leg_ = FR_;  // leg that waits, and the one across from it
};

}  // namespace surefoot
