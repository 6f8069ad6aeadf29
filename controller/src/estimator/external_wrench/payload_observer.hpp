// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dynamics/dynamics.hpp"
#include "surefoot/gains.hpp"

namespace surefoot {

/// Slow wrench from outside on the robot: a payload, a mass that is not the model's, a lean.
///
/// The centroidal momentum changes by the feet's forces, gravity, and what is unknown:
///   m v_com' = sum f + m g + F,   L_com' = sum (p - c) x f + N.
/// A first-order observer of the momentum (as De Luca, Mattone 2003 for joints) finds F and N with
/// no acceleration. Forces come from joint torques, so torques that are wrong by a scale enter as a
/// wrench that makes the commanded ones hold the robot all the same. Bounded; frozen while the
/// robot is not carried by its feet. Real-time: yes.
class PayloadObserver {
 public:
  explicit PayloadObserver(double mass) : mass_(mass) {}

  /// @param dynamics at this tick's state, velocity included
  /// @param forces ground on feet, world axes [N]
  /// @param supported do the feet bear the robot, and are the torques to be had?
  void update(const Gains& gains, const Dynamics& dynamics, const FeetMatrix& forces,
              bool supported, double dt) noexcept;

  const Vector3& force() const noexcept { return force_; }    ///< [N] world axes
  const Vector3& moment() const noexcept { return moment_; }  ///< [N.m] about the centre of mass
  double mass() const noexcept { return -force_.z() / kGravity; }  ///< [kg] of the payload
  /// From the model's centre of mass to the loaded robot's, horizontal, world axes [m].
  Vector3 com_shift() const noexcept;

  void reset() noexcept { *this = PayloadObserver(mass_); }

 private:
  void freeze_estimate(const Gains& gains, const Vector3& linear, const Vector3& angular) noexcept;

  double mass_;
  bool started_ = false;
  Vector3 linear_momentum_ = Vector3::Zero(),
          angular_momentum_ = Vector3::Zero();  // momentum that is explained
  Vector3 force_ = Vector3::Zero(), moment_ = Vector3::Zero();
};

}  // namespace surefoot
