// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "dynamics/dynamics.hpp"
#include "reference/support_frame.hpp"
#include "surefoot/gains.hpp"

namespace surefoot {

/// Recovery steps: moves feet towards the capture point when a push is about to topple the robot.
///
/// While the capture point is far inside the support polygon, each foot stays at its nominal
/// position. When the capture point is near a support edge, the stance feet can hardly brake any
/// more, and feet step by the stride. The stride is the vector from the support origin to the
/// capture point, times the edge proximity (0 far inside, 1 at the edge), limited to the gain
/// foot_step. The stride is the same for all swing feet. A foot that has lost contact moves from
/// its nominal position by the stride, and is then pressed to the ground. The foot stays where it
/// lands, and its nominal position moves there.
///
/// When the capture point is outside, foot_to_lift() selects a loaded foot whose step brings the
/// capture point back inside. This foot is unloaded and steps in the same way. Only one foot is
/// unloaded at a time. Collisions between legs are not checked. Real-time: yes.
/// Source for stepping to the capture point: Pratt et al. 2006.
class RecoverySteps {
 public:
  void reset() noexcept { *this = {}; }

  /// Update the phases and the desired offsets of all feet.
  /// @param p_world_feet contact points minus their displacement by rolling, world frame [m]
  /// @param contact contact confidence per foot, 0 .. 1
  /// @param support in and out: update() moves the nominal positions of feet that have landed
  void update(const Gains& gains, const Dynamics& dynamics, const FeetMatrix& p_world_feet,
              const Eigen::Vector4d& contact, SupportFrame& support, double dt) noexcept;

  /// Stop all steps, because the robot is lifted or has lost a leg. The offsets decay to zero over
  /// several calls.
  void stop(double dt) noexcept;

  /// Offset [m] of each foot's desired position from its nominal position, world axes.
  const FeetMatrix& foot_offsets() const noexcept { return foot_offsets_; }

  /// Prepare the input of SupportFrame::update(): subtract the offsets from all feet. For a foot
  /// that lifts off or swings, set its position to its nominal position and its contact confidence
  /// to 0.
  /// @param p_world_feet in and out: contact points minus their displacement by rolling, world
  ///   frame [m]
  /// @param contact in and out: contact confidence per foot, 0 .. 1
  void exclude_swing_feet(const SupportFrame& support, FeetMatrix& p_world_feet,
                          Eigen::Vector4d& contact) const noexcept;

  /// Return whether the foot is in contact and is being unloaded for a step.
  bool is_lifting_off(int leg) const noexcept { return phase_[leg] == FootPhase::kLiftingOff; }

 private:
  // kLiftingOff: the foot is still in contact and is being unloaded.
  enum class FootPhase { kStance, kLiftingOff, kSwinging };

  void update_stride(const Gains& gains, const SupportFrame& support,
                     const FeetMatrix& p_world_nominal_feet,
                     const Eigen::Vector2d& capture) noexcept;
  void select_foot_to_lift(const FeetMatrix& p_world_feet, const FeetMatrix& p_world_nominal_feet,
                           const Eigen::Vector4d& contact, const Eigen::Vector2d& capture,
                           double min_margin) noexcept;
  void update_phase(int leg, double contact, const Vector3& from_nominal) noexcept;
  void update_swing(int leg, const Vector3& from_nominal, const Vector3& normal, double height,
                    double dt) noexcept;

  FeetMatrix foot_offsets_ = FeetMatrix::Zero();
  Vector3 stride_ = Vector3::Zero();  // [m] stride, world axes, in the support plane
  // 1: the capture point is at an edge of the polygon of the nominal foot positions, or outside. 0:
  // it is inside by at least the gain edge_margin.
  double edge_proximity_ = 0.0;
  bool body_moving_ = false;  // true: the body moves (see kMovingDistance)
  std::array<FootPhase, kLegs> phase_{};
  // True for each foot that failed to lift off, and is not selected again. All are cleared when the
  // capture point is inside again.
  std::array<bool, kLegs> lift_failed_{};
  // [sqrt(h / g)] Time since the start of the step, unloading included.
  std::array<double, kLegs> phase_time_{};
};

}  // namespace surefoot
