// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "supervisor/common/tilt.hpp"

namespace surefoot {

/// Detects a lying body that rolls over its folding legs.
///
/// A roll is a tilt above kRollTilt that has grown by kMinTiltIncrease. The legs are then released
/// for kReleaseTime, early enough for the body to fall back; twice at most. A body that rolls on
/// all the same has rolled over: its legs are not where the model has them, or an obstacle is in
/// the way. Real-time: yes.
class RolloverMonitor {
 public:
  /// @param up the world's vertical in base axes, unit length
  void start(const Vector3& up) noexcept {
    *this = {};
    initial_tilt_ = tilt_angle(up);
  }
  /// Advance by dt [s]. @param up the world's vertical in base axes, unit length
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
  int rolls() const noexcept { return rolls_; }  ///< since start()
  bool releases_legs() const noexcept {
    return release_time_left_ > 0.0;
  }  ///< the legs must be released now
  bool rolled_over() const noexcept { return rolled_over_; }

 private:
  // Chosen between rises measured with benchmarks/false_trips.py (docs/faults.md): no trip of a go2
  // in 515 rises.
  static constexpr double kRollTilt = 0.44;         // [rad] 25 degrees: ArmingChecks' kMaxTilt ...
  static constexpr double kMinTiltIncrease = 0.12;  // [rad] ... and 7 degrees over the initial tilt
  static constexpr double kReleaseTime = 1.0;       // [s] until the body lies again
  // [rad] 42 degrees. After a release healthy robots fall back from up to 0.7.
  static constexpr double kRolledOverTilt = 0.74;
  // [rad] 39.5 degrees. Healthy robots do not roll this far again after two releases. They may
  // pitch as far, on a front leg caught below them, and come down when it comes free.
  static constexpr double kRepeatedRoll = 0.69;
  static constexpr int kMaxRolls = 2;  // releases

  double initial_tilt_ = 0.0;  // [rad] at the start, then after each release
  int rolls_ = 0;
  bool rolled_over_ = false;
  double release_time_left_ = 0.0;  // [s]
};

}  // namespace surefoot
