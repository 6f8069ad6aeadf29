// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "dynamics/dynamics.hpp"
#include "reference/support_frame.hpp"
#include "surefoot/gains.hpp"

namespace surefoot {

/// Recovery steps: moves feet towards the capture point when a push is about to topple the robot.
///
/// Far from the support edge each foot stays at its nominal position. With the capture point near
/// an edge, the stance feet can hardly brake any more. Then a foot that has lost contact swings by
/// the displacement of the capture point, foot_step at most, and is pressed to the ground. It stays
/// where it lands, and its nominal position moves there. With the capture point outside, a loaded
/// foot is unloaded and steps likewise, if that brings the capture point back inside
/// (foot_to_lift()); only one foot is unloaded at a time. All swing feet get the same stride. Legs
/// are not checked for collisions with each other. Real-time: yes.
/// Source: Pratt et al. 2006, for stepping to the capture point.
class RecoverySteps {
 public:
  void reset() noexcept { *this = {}; }

  /// Update phases and desired offsets of all feet.
  /// @param p_world_feet contact points without their displacement by rolling
  /// @param contact contact confidence per foot, 0 .. 1
  /// @param support its nominal foot positions move to feet that have landed
  void update(const Gains& gains, const Dynamics& dynamics, const FeetMatrix& p_world_feet,
              const Eigen::Vector4d& contact, SupportFrame& support, double dt) noexcept;

  /// Stop stepping, for a robot that is lifted or has lost a leg: offsets decay to zero.
  void stop(double dt) noexcept;

  /// Offset [m] of each foot's desired position from its nominal position, world axes.
  const FeetMatrix& foot_offsets() const noexcept { return foot_offsets_; }

  /// Prepare feet and contact confidences for SupportFrame::update(): remove the offsets, and
  /// exclude feet that lift off or swing.
  void mask_swing_feet(const SupportFrame& support, FeetMatrix& p_world_feet,
                       Eigen::Vector4d& contact) const noexcept;

  /// Return whether the foot is in contact and is being unloaded for a step.
  bool is_lifting_off(int leg) const noexcept { return phase_[leg] == FootPhase::kLiftingOff; }

 private:
  enum class FootPhase { kStance, kLiftingOff, kSwinging };

  void update_stride(const Gains& gains, const SupportFrame& support,
                     const FeetMatrix& p_world_nominal_feet,
                     const Eigen::Vector2d& capture) noexcept;
  void select_foot_to_lift(const FeetMatrix& p_world_feet, const FeetMatrix& p_world_nominal_feet,
                           const Eigen::Vector4d& contact, const Eigen::Vector2d& capture,
                           double gain) noexcept;
  void update_phase(int leg, double contact, const Vector3& from_nominal) noexcept;
  void update_swing(int leg, const Vector3& from_nominal, const Vector3& normal, double height,
                    double dt) noexcept;

  FeetMatrix foot_offsets_ = FeetMatrix::Zero();
  Vector3 stride_ = Vector3::Zero();  // [m] required stride, world axes, in the support plane
  double edge_proximity_ = 0.0;       // 1: capture point at the edge or outside, 0: far inside
  bool moving_ = false;               // the capture point is well ahead of the centre of mass
  std::array<FootPhase, kLegs> phase_{};
  // Feet that failed to lift off; cleared when the capture point is inside again.
  std::array<bool, kLegs> lift_failed_{};
  std::array<double, kLegs> phase_time_{};  // [sqrt(h / g)] since the step began
};

}  // namespace surefoot
