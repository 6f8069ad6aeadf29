// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "gait/body_sway.hpp"
#include "gait/body_trajectory.hpp"
#include "gait/step_schedule.hpp"

namespace surefoot {

/// Decides when a gait walk changes to a trot after a push, and when it may walk again. Real-time:
/// yes.
///
/// A push moves the capture point from its planned place by e. To keep e from growing, the
/// zero-moment point must move by e from its planned place too. If it would leave the polygon of
/// the stance feet, the robot must step. An error below 0.15 h needs no step. Source: Englsberger,
/// Ott, Albu-Schaeffer 2015.
class WalkRecovery {
 public:
  explicit WalkRecovery(const GaitSize& size) : size_(size) {}

  void start() noexcept {
    trots_ = false;
    calm_time_ = 0.0;
  }
  /// Process one tick in which a gait walk is wanted.
  /// @param measured measured motion of the body, without sway
  /// @param body planned motion, without sway
  /// @param sway planned sway
  /// @return whether the robot must trot
  bool update(const PlannerInput& input, const StepSchedule& schedule,
              const HorizontalMotion& measured, const BodyTrajectory& body,
              const BodySway& sway) noexcept;

 private:
  GaitSize size_;
  bool trots_ = false;
  double calm_time_ = 0.0;  // [s] for which the capture point has been near the planned one
};

}  // namespace surefoot
