// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>

#include "surefoot/low_level.hpp"
#include "surefoot/math.hpp"

namespace surefoot {

/// Folding order of a lying robot's legs: decides which diagonal pair waits until the other pair
/// has folded.
///
/// The legs of a leaning body support the body and keep it from rolling over. The front leg on the
/// lower side supports most, so the diagonal pair with this front leg waits. There are two
/// exceptions:
/// - If this front leg is drawn in under the body, and the knee of the other front leg is not up,
///   the diagonal pair with the other front leg waits.
/// - If the rear leg of the chosen pair is drawn in with its knee down, this rear leg would roll
///   the body over after the other legs have folded. Then the other pair waits, unless its rear leg
///   too is drawn in with its knee down.
///
/// The wait is limited, because the legs may block each other. On a level body no pair waits. For
/// robots with a wide belly, the gain fold_wait is 0, so that no pair ever waits. Real-time: yes.
class FoldingOrder {
 public:
  struct Leg {
    double inward = 0.0;  ///< [rad] hip angle, positive inward
    double thigh = 0.0;   ///< [rad] thigh angle, positive in the folding direction
  };
  /// Choose the pair that waits.
  /// @param up the world's vertical in base axes, unit length
  /// @param legs angles of FR, FL, RR, RL
  /// @param always true: a pair waits even if the body is level
  /// @param wait longest wait [s]; with 0 all legs fold at once
  void start(const Vector3& up, const std::array<Leg, kLegs>& legs, bool always,
             double wait) noexcept {
    time_left_ = always || std::hypot(up.x(), up.y()) > kMinTilt ? wait : 0.0;
    const int lower = up.y() > 0.0 ? FR_ : FL_;
    // The chosen front leg is drawn in, and the knee of the other front leg is not up.
    const bool crossed = legs[lower].inward > kHipInward && legs[1 - lower].thigh < kKneeUp;
    waiting_front_leg_ = crossed ? 1 - lower : lower;
    const auto turns_over = [&](int front) {
      const Leg& rear = legs[diagonal_leg(front)];
      return rear.inward > kHipInward && rear.thigh < kKneeUp;
    };
    if (turns_over(waiting_front_leg_) && !turns_over(1 - waiting_front_leg_))
      waiting_front_leg_ = 1 - waiting_front_leg_;
  }
  /// Advance by dt [s].
  /// @param others_folded true if all legs that do not wait are folded
  void update(bool others_folded, double dt) noexcept {
    time_left_ = others_folded ? 0.0 : time_left_ - dt;
  }
  /// Return whether a leg waits now.
  bool waits(int leg) const noexcept {
    return time_left_ > 0.0 &&
           (leg == waiting_front_leg_ || leg == diagonal_leg(waiting_front_leg_));
  }

 private:
  // The constants are chosen by hand from rises of a go2 (benchmarks/false_trips.py: no trip in 515
  // rises). The angles are the same as in folding_path.cpp. Test:
  // legs_of_a_leaning_body_fold_one_diagonal_pair_at_a_time.
  //
  // The body leans if the sine of its tilt is larger than this: 11.5 degrees.
  static constexpr double kMinTilt = 0.2;
  // [rad] Hip angle above which a leg is drawn in under the body.
  static constexpr double kHipInward = 0.5;
  static constexpr double kKneeUp = 2.2;  // [rad] thigh angle from which the knee is up

  double time_left_ = 0.0;       // [s] time until the pair stops waiting
  int waiting_front_leg_ = FR_;  // front leg of the waiting pair; its diagonal leg waits too
};

}  // namespace surefoot
