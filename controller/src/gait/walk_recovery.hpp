// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dynamics/dynamics.hpp"
#include "gait/body_trajectory.hpp"
#include "gait/step_schedule.hpp"

namespace surefoot {

/// Tells when a gait walk must trot because of a push, and when it may walk again. Real-time: yes.
///
/// The stance feet of a walk can bring a capture point back that is within their support polygon.
/// If it leaves the polygon, the robot must step.
class WalkRecovery {
 public:
  explicit WalkRecovery(const GaitSize& size) : size_(size) {}

  void start() noexcept { trots_ = false; }
  /// Process one tick.
  /// @param measured measured motion of the body, without sway
  /// @param planned where the body trajectory has it
  /// @return whether the robot must trot
  bool update(const Dynamics& dynamics, const StepSchedule& schedule,
              const HorizontalMotion& measured, const HorizontalMotion& planned,
              double dt) noexcept;

 private:
  GaitSize size_;
  bool trots_ = false;
  double calm_time_ = 0.0;  // [s] for which the capture point has been near the planned one
};

}  // namespace surefoot
