// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "dynamics/dynamics.hpp"
#include "reference/support_frame.hpp"
#include "surefoot/gains.hpp"

namespace surefoot {

/// Where feet are put down that a push threw off the ground, and which that bear step by
/// themselves.
///
/// While it can be afforded, a foot belongs to its place. With the capture point near the support's
/// edge the feet that stand have nothing left to brake with: a foot that bears next to nothing is
/// lifted, goes the way that the capture point has gone, by foot_step at most, and is pressed to
/// the ground before the body has got much further. Where it lands it stays, and its place in the
/// support comes to it. With the capture point outside, a foot that bears is unloaded and steps
/// likewise, if that brings the capture point back inside: one is unloaded at a time
/// (foot_to_lift). All free feet are given the same stride; nothing keeps a leg from meeting one
/// that stands. Real-time: yes.
/// Source: Pratt et al. 2006, of stepping where the capture point is.
class RecoverySteps {
 public:
  void reset() noexcept { *this = {}; }

  /// @param p_world_feet contact points, less what they rolled
  /// @param contact belief per foot, 0 .. 1
  /// @param support its places are moved to where feet have landed
  void update(const Gains& gains, const Dynamics& dynamics, const FeetMatrix& p_world_feet,
              const Eigen::Vector4d& contact, SupportFrame& support, double dt) noexcept;

  /// Of a robot that hangs in the air, or has lost a leg: no foot swings, and those that do come
  /// back to their places.
  void stop(double dt) noexcept;

  /// [m] from each foot's place to where it belongs now, world
  const FeetMatrix& foot_offsets() const noexcept { return foot_offsets_; }

  /// What the feet tell of the support: those that swing nothing, they are not where they belong.
  void mask_swing_feet(const SupportFrame& support, FeetMatrix& p_world_feet,
                       Eigen::Vector4d& contact) const noexcept;

  /// Is it a foot that bore, and is to bear nothing now, so as to leave the ground?
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
  Vector3 stride_ = Vector3::Zero();  // [m] that the capture point asks for, world, in the support
  double edge_proximity_ = 0.0;       // share: 1 with the capture point at the edge, 0 far inside
  bool moving_ = false;               // fast enough that where it goes is not where it is
  std::array<FootPhase, kLegs> phase_{};
  std::array<bool, kLegs>
      lift_failed_{};  // was to leave the ground and did not; until edge_proximity_ < 1
  std::array<double, kLegs> phase_time_{};  // [sqrt(h / g)] since it was to leave the ground
};

}  // namespace surefoot
