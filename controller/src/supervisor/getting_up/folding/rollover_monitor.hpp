// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "supervisor/common/tilt.hpp"

namespace surefoot {

/// Does a lying body roll over the legs that fold under it? It is let go of then, while it may
/// still fall back, twice. One that goes over all the same rolls on: they are not where they are
/// thought to be, or something else is in the way. Real-time: yes.
class RolloverMonitor {
 public:
  /// @param up the world's vertical, in base axes
  void start(const Vector3& up) noexcept {
    *this = {};
    initial_tilt_ = tilt_angle(up);
  }
  /// @param up the world's vertical, in base axes @param dt [s]
  void update(const Vector3& up, double dt) noexcept {
    const double tilt = tilt_angle(up);
    const bool rolled_again =
        rolls_ == kMaxRolls && !releases_legs() && std::abs(roll_angle(up)) > kRepeatedRoll;
    rolled_over_ = rolled_over_ || rolled_again || (rolls_ > 0 && tilt > kRolledOverTilt);
    if (releases_legs()) {
      release_time_left_ -= dt;
      if (!releases_legs()) initial_tilt_ = tilt;  // as it lies now
      return;
    }
    if (rolls_ == kMaxRolls || !(tilt > kRollTilt && tilt > initial_tilt_ + kMinTiltIncrease))
      return;
    ++rolls_;
    release_time_left_ = kReleaseTime;
  }
  int rolls() const noexcept { return rolls_; }  ///< so far
  bool releases_legs() const noexcept {
    return release_time_left_ > 0.0;
  }  ///< of the legs, for now
  bool rolled_over() const noexcept { return rolled_over_; }

 private:
  static constexpr double kRollTilt = 0.44;  // [rad] 25 degrees: most that a robot is armed at ...
  static constexpr double kMinTiltIncrease = 0.12;  // [rad] ... and no lean that was there before
  static constexpr double kReleaseTime = 1.0;       // [s] until it lies again
  static constexpr double kRolledOverTilt =
      0.74;  // [rad] healthy ones fall back from 0.7, let go of ...
  // [rad] ... and are not this far on one side again after two rolls. They pitch as far, propped
  // up by a front leg that is caught below them, and come down when it comes free.
  static constexpr double kRepeatedRoll = 0.69;
  static constexpr int kMaxRolls = 2;

  double initial_tilt_ = 0.0;  // [rad] lean as it lay
  int rolls_ = 0;
  bool rolled_over_ = false;
  double release_time_left_ = 0.0;  // [s]
};

}  // namespace surefoot
