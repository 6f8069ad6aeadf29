// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "gait/body_trajectory.hpp"

namespace surefoot {

/// Tells when a gait walk must trot because of a push, and when it may walk again. Real-time: yes.
class WalkRecovery {
 public:
  explicit WalkRecovery(const GaitSize& size) : size_(size) {}

  void start() noexcept { trots_ = false; }
  /// Process one tick.
  /// @param measured measured motion of the body, without sway
  /// @param planned where the body trajectory has it
  /// @param walks whether the feet step in the order of a walk now
  /// @param period of the gait [s]
  /// @return whether the robot must trot
  bool update(const HorizontalMotion& measured, const HorizontalMotion& planned, bool walks,
              double period, double dt) noexcept;

 private:
  GaitSize size_;
  bool trots_ = false;
  double calm_time_ = 0.0;  // [s] for which the capture point has been near the planned one
};

}  // namespace surefoot
