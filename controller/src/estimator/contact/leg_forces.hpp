// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dynamics/dynamics.hpp"

namespace surefoot {

/// Return for each joint the stop on which it may rest: 1 upper, -1 lower, 0 none. SDK motor order.
/// @param q joint angles, SDK motor order [rad]
Vector12 joint_stops(const RobotConfig& config, const Vector12& q) noexcept;

/// Contact force on each foot, computed from the joint torques of its leg.
///
/// The class solves the leg's rows of the equations of motion for the force f:
///   f = -J^-T (tau - h - M_bl^T a_b - M_l ddq), with M_bl = LegDynamics::M_base_leg.
/// A first-order filter replaces ddq by a difference of velocities. The result is the
/// generalised-momentum observer (De Luca, Mattone 2003) for a leg whose base acceleration is
/// measured by the IMU. It needs no joint accelerations, and its forces lag by kFilterTime.
///
/// Torque that a joint may exert against its own stop is not attributed to the ground. Otherwise a
/// lifted robot could stay in false contact: the weight of the legs extends them to the stops, the
/// controller presses a leg that it takes for a stance leg onto its stops, and this torque looks
/// like a contact force. Real-time: yes.
class LegForces {
 public:
  /// [s] Time constant of the momentum observer. Chosen. If smaller: the forces contain the encoder
  /// noise. Shorter than contact_dwell, 10 ms. surefoot/tune/design/loop_model.py has a copy of the
  /// value.
  static constexpr double kFilterTime = 0.005;

  /// Process one tick.
  /// @param dynamics dynamics at the angular velocity of the base and zero linear velocity
  /// @param a_base classical acceleration of the base origin without gravity, base axes [m/s^2]
  /// @param alpha_base angular acceleration of the base, base axes [rad/s^2]
  /// @param tau_est joint torques, SDK motor order [N.m]
  /// @param dq joint velocities, SDK motor order [rad/s]
  /// @param stops result of joint_stops()
  void update(const Dynamics& dynamics, const Vector3& a_base, const Vector3& alpha_base,
              const Vector12& tau_est, const Vector12& dq, const Vector12& stops,
              double dt) noexcept;

  /// Forces of the ground on the feet [N], FR FL RR RL, world axes.
  const FeetMatrix& forces() const noexcept { return forces_; }
  /// Joint torques that accelerate the legs if no force acts on the feet [N.m], SDK motor order:
  /// tau - h - M_bl^T a_b, where h is without joint friction, and every term has the delay of one
  /// filter. In forces(), alpha_base has passed two filters, because of the vibration of the
  /// gyroscope.
  const Vector12& swing_torque() const noexcept { return swing_torque_; }

  void reset() noexcept { *this = LegForces(); }

 private:
  bool started_ = false;
  Vector12 residual_ = Vector12::Zero();     // [N.m] tau - h - M_bl^T (a_base, 0), filtered
  Vector12 rotation_ = Vector12::Zero();     // [N.m] M_bl^T (0, alpha_base), filtered
  Vector12 dq_filtered_ = Vector12::Zero();  // [rad/s] joint velocities, filtered
  Vector12 friction_ = Vector12::Zero();     // [N.m] joint friction in h, filtered
  Vector12 swing_torque_ = Vector12::Zero();
  FeetMatrix forces_ = FeetMatrix::Zero();
};

}  // namespace surefoot
