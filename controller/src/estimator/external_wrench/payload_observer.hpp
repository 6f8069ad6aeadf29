// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dynamics/dynamics.hpp"
#include "surefoot/gains.hpp"

namespace surefoot {

/// Observer of the sustained external wrench: a payload, a mass error of the model, a steady lean.
///
/// Contact forces f at p, gravity and the external wrench (F, N) change the centroidal momentum:
///   m v_com' = sum f + m g + F,   L_com' = sum (p - c) x f + N.
/// A first-order momentum observer (De Luca, Mattone 2003, there for joints) estimates F and N
/// without accelerations. The contact forces come from joint torques. So a scale error of the
/// torques is estimated as a wrench too, and compensating it still makes the commanded torques hold
/// the robot. The estimate is bounded, and frozen while the feet do not carry the robot.
/// Real-time: yes.
class PayloadObserver {
 public:
  explicit PayloadObserver(double mass) : mass_(mass) {}

  /// Process one tick.
  /// @param dynamics at the present state, including velocity
  /// @param forces ground on feet, world axes [N]
  /// @param supported true if the feet carry the robot and the torques are usable
  void update(const Gains& gains, const Dynamics& dynamics, const FeetMatrix& forces,
              bool supported, double dt) noexcept;

  const Vector3& force() const noexcept { return force_; }    ///< [N] world axes
  const Vector3& moment() const noexcept { return moment_; }  ///< [N.m] about the centre of mass
  double mass() const noexcept { return -force_.z() / kGravity; }  ///< [kg] of the payload
  /// Compute the horizontal shift of the centre of mass, loaded minus model, world axes [m].
  Vector3 com_shift() const noexcept;

  void reset() noexcept { *this = PayloadObserver(mass_); }

 private:
  void freeze_estimate(const Gains& gains, const Vector3& linear, const Vector3& angular) noexcept;

  double mass_;
  bool started_ = false;
  // Momentum predicted from contact forces, gravity and the estimated wrench.
  Vector3 linear_momentum_ = Vector3::Zero(), angular_momentum_ = Vector3::Zero();
  Vector3 force_ = Vector3::Zero(), moment_ = Vector3::Zero();
};

}  // namespace surefoot
