// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dynamics/dynamics.hpp"

namespace surefoot {

/// On which stop each joint may rest: 1 its upper, -1 its lower, 0 none. SDK motor order.
Vector12 joint_stops(const RobotConfig& config, const Vector12& q) noexcept;

/// Force of the ground on each foot from the leg's joint torques.
///
/// The leg's rows of the equations of motion, f = -J^-T (tau - h - M_lb a_b - M_l q''), through a
/// first-order filter that turns q'' into a difference of velocities: the generalised-momentum
/// observer (De Luca, Mattone 2003) of a leg whose base's acceleration is measured, by the IMU. It
/// takes no joint acceleration and lags by kFilterTime. What a joint presses on its own stop is
/// none of the ground's: without this the legs of a lifted robot, stretched by their weight, press
/// on their stops because they are believed to stand, and are because they press. Real-time: yes.
class LegForces {
 public:
  static constexpr double kFilterTime = 0.005;  ///< [s]

  /// @param dynamics updated with the base's rate and no linear velocity
  /// @param a_base acceleration of the base's origin, base axes [m/s^2], gravity not in it
  /// @param alpha_base [rad/s^2] base axes
  /// @param tau_est,dq [N.m], [rad/s] SDK motor order
  /// @param stops as joint_stops() has them
  void update(const Dynamics& dynamics, const Vector3& a_base, const Vector3& alpha_base,
              const Vector12& tau_est, const Vector12& dq, const Vector12& stops,
              double dt) noexcept;

  /// World axes [N], FR FL RR RL.
  const FeetMatrix& forces() const noexcept { return forces_; }

  void reset() noexcept { *this = LegForces(); }

 private:
  bool started_ = false;
  Vector12 residual_ = Vector12::Zero();     // tau - h - M_lb a_b, filtered [N.m]
  Vector12 dq_filtered_ = Vector12::Zero();  // filtered [rad/s]
  FeetMatrix forces_ = FeetMatrix::Zero();
};

}  // namespace surefoot
