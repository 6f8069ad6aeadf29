// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>

#include "surefoot/low_level.hpp"
#include "surefoot/math.hpp"

namespace surefoot {

/// Folding order of a lying robot's legs: which diagonal pair waits until the other has folded.
///
/// The legs of a leaning body support it and keep it from rolling over. The pair that waits is the
/// one whose front leg supports the lower side. That is the front leg of that side. If it is drawn
/// in under the body, it is the other front leg, unless the knee of that one is up. A rear leg that
/// is drawn in with its knee down would turn the body over once the others are folded, so its pair
/// does not wait, unless this is true of both pairs. The wait is limited, because the legs may
/// block one another. Level bodies need no order, and robots with a wide belly set the wait to 0.
/// Real-time: yes.
class FoldingOrder {
 public:
  struct Leg {
    double inward = 0.0;  ///< [rad] hip angle inward
    double thigh = 0.0;   ///< [rad] thigh angle, positive in folding direction
  };
  /// Choose the pair that waits.
  /// @param up the world's vertical in base axes, unit length @param legs FR, FL, RR, RL
  /// @param always let a pair wait even if the body is level
  /// @param wait longest wait [s]; 0: all legs fold at once
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
  /// Advance by dt [s]. @param others_folded whether all legs that do not wait are folded
  void update(bool others_folded, double dt) noexcept {
    time_left_ = others_folded ? 0.0 : time_left_ - dt;
  }
  /// Return whether a leg waits now.
  bool waits(int leg) const noexcept {
    return time_left_ > 0.0 &&
           (leg == waiting_front_leg_ || leg == diagonal_leg(waiting_front_leg_));
  }

 private:
  // Chosen by hand from rises of a go2 (benchmarks/false_trips.py: no trip in 515 rises). Angles as
  // in folding_path.cpp. Test: legs_of_a_leaning_body_fold_one_diagonal_pair_at_a_time.
  static constexpr double kMinTilt = 0.2;    // sine of 11.5 degrees: the body lies on something
  static constexpr double kHipInward = 0.5;  // [rad] drawn in under the body
  static constexpr double kKneeUp = 2.2;     // [rad] thigh angle with the knee up

  double time_left_ = 0.0;       // [s] of waiting left
  int waiting_front_leg_ = FR_;  // waits together with its diagonal leg
};

}  // namespace surefoot
