// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dynamics/dynamics.hpp"
#include "surefoot/gains.hpp"

namespace surefoot {

/// Observer of the sustained external wrench, which comes from a payload, a mass error of the
/// model, or a steady push.
///
/// Contact forces f at p, gravity and the external wrench (F, N) change the linear and angular
/// momentum:
///   m dv_com/dt = sum f + m g + F,   dL_com/dt = sum (p - p_com) x f + N.
/// A first-order momentum observer estimates F and N without measured accelerations (De Luca,
/// Mattone 2003, there for joints). The estimate is bounded. It does not change while the feet do
/// not carry the robot. While feet step, it is the mean of the last second at rest, whose
/// moment turns with the robot: a push that makes a standing robot step is no payload.
///
/// The contact forces come from joint torques, so a scale error of the torques appears as an
/// external wrench too. This is harmless: if the controller compensates this wrench, the commanded
/// torques still hold the robot. Real-time: yes.
class PayloadObserver {
 public:
  explicit PayloadObserver(double mass) : mass_(mass) {}

  /// Process one tick.
  /// @param dynamics dynamics at the present state, including the linear velocity of the base
  /// @param forces contact forces on the feet, FR FL RR RL, world axes [N]
  /// @param supported true if the feet carry the robot and joint torques are available, measured or
  ///   planned
  /// @param stepping true if the planner lets feet step
  void update(const Gains& gains, const Dynamics& dynamics, const FeetMatrix& forces,
              bool supported, bool stepping, double dt) noexcept;

  const Vector3& force() const noexcept { return force_; }  ///< [N] world axes
  /// [N.m] about the centre of mass, world axes
  const Vector3& moment() const noexcept { return moment_; }
  /// [kg] estimated mass of the payload
  double mass() const noexcept { return -force_.z() / kGravity; }
  /// Compute the horizontal shift of the centre of mass that the payload causes, world axes [m].
  Vector3 com_shift() const noexcept;

  void reset() noexcept { *this = PayloadObserver(mass_); }

 private:
  void average_at_rest(const Dynamics& dynamics, double dt) noexcept;
  void reset_momentum(const Gains& gains, const Vector3& linear, const Vector3& angular) noexcept;

  double mass_;
  bool started_ = false;
  // [N.s], [N.m.s] Momentum predicted from contact forces, gravity and the estimated wrench.
  Vector3 linear_momentum_ = Vector3::Zero(), angular_momentum_ = Vector3::Zero();
  Vector3 force_ = Vector3::Zero(), moment_ = Vector3::Zero();
  // Mean wrench of about the last second in which the robot stood at rest: force in world axes,
  // moment in heading axes, because the lever arm of a payload turns with the robot.
  Vector3 force_at_rest_ = Vector3::Zero(), moment_at_rest_ = Vector3::Zero();
};

}  // namespace surefoot
