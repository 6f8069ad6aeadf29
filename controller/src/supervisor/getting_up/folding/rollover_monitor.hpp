// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "supervisor/common/tilt.hpp"

namespace surefoot {

/// Detects a lying body that rolls over its folding legs.
///
/// A roll is a tilt above kRollTilt that has grown by kMinTiltIncrease. The legs are then released
/// for kReleaseTime, early enough for the body to fall back. The legs are released at most twice.
/// The body counts as rolled over if, after a release, its tilt exceeds kRolledOverTilt, or if,
/// after two releases, its roll angle exceeds kRepeatedRoll. Then the legs are not where the model
/// assumes them, or an obstacle is in the way. Real-time: yes.
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
      // At the end of the release, the present tilt becomes the initial tilt.
      if (!releases_legs()) initial_tilt_ = tilt;
      return;
    }
    if (rolls_ == kMaxRolls || !(tilt > kRollTilt && tilt > initial_tilt_ + kMinTiltIncrease))
      return;
    ++rolls_;
    release_time_left_ = kReleaseTime;
  }
  int rolls() const noexcept { return rolls_; }  ///< number of rolls since start()
  /// Return whether the legs must be released now.
  bool releases_legs() const noexcept { return release_time_left_ > 0.0; }
  bool rolled_over() const noexcept { return rolled_over_; }

 private:
  // The limits are chosen between tilts measured with benchmarks/false_trips.py
  // (docs/explanation/getting-up.md): no trip of a go2 in 515 rises.
  //
  // [rad] 25 degrees: tilt above which the body may be rolling; same as kMaxTilt in
  // arming_checks.cpp.
  static constexpr double kRollTilt = 0.44;
  // [rad] 7 degrees: the body rolls if its tilt has grown by more than this.
  static constexpr double kMinTiltIncrease = 0.12;
  // [s] Duration of a release. After this time the body lies again.
  static constexpr double kReleaseTime = 1.0;
  // [rad] 42 degrees: tilt above which the body has rolled over, if it has rolled before. Larger
  // than 0.7 rad, the largest tilt from which healthy robots fell back during a release.
  static constexpr double kRolledOverTilt = 0.74;
  // [rad] 39.5 degrees: roll angle above which the body has rolled over after two releases. Healthy
  // robots do not roll that far again. Pitch is not limited here: a healthy robot may pitch that
  // far while a front leg is caught below its body, and comes down when this leg comes free.
  static constexpr double kRepeatedRoll = 0.69;
  static constexpr int kMaxRolls = 2;  // largest number of releases

  double initial_tilt_ = 0.0;  // [rad] tilt at the start or after the last release
  int rolls_ = 0;
  bool rolled_over_ = false;
  double release_time_left_ = 0.0;  // [s] time until the release ends
};

}  // namespace surefoot
