// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "surefoot/math.hpp"

namespace surefoot {

/// Sees legs that their own torques fling: the foot has lost the ground, or slides off on it.
///
/// Such a leg gathers speed until it takes more power than the robot is allowed, within 15 ms; as
/// a wheel that locks, it holds better when it is let go of for an instant. A leg that bears the
/// body moves with it: a body that falls turns its joints by g over a leg's length, 40 rad/s^2.
/// Real-time: yes.
class FlungLeg {
 public:
  /// Look at the joints, once a tick. @param dq shape (12,) [rad/s] @param dt [s] since the last
  void update(const Vector12& dq, double dt) noexcept {
    if (known_ && dt > 0.0) ddq_ += dt / (dt + kSmooth) * ((dq - dq_) / dt - ddq_);
    dq_ = dq;
    known_ = true;
  }
  /// Share of a leg's torques tau [N.m] that is left to it: 1 where nothing flings it.
  double keep(const Vector12& tau, int leg) const noexcept {
    double most = 0.0;
    for (int i = kLegJoints * leg; i < kLegJoints * (leg + 1); ++i) {
      if (tau[i] * dq_[i] > 0.0) most = std::max(most, dq_[i] > 0.0 ? ddq_[i] : -ddq_[i]);
    }
    return 1.0 - std::clamp(most / kFling - 1.0, 0.0, 1.0);
  }
  void reset() noexcept { *this = {}; }

 private:
  // [rad/s^2] from which on it is let go of; wholly at twice as much.
  static constexpr double kFling = 80.0;
  static constexpr double kSmooth = 0.002;  // [s] of the encoders' noise

  Vector12 dq_ = Vector12::Zero();   // [rad/s]
  Vector12 ddq_ = Vector12::Zero();  // [rad/s^2]
  bool known_ = false;
};

}  // namespace surefoot
