// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "surefoot/estimator_report.hpp"
#include "surefoot/robot.hpp"
#include "surefoot/types.hpp"

namespace surefoot {

class Dynamics;

/// Estimator of base state, contacts and external wrench from the robot's own sensors: LowState in,
/// RobotState out.
///
/// A contact-aided invariant extended Kalman filter (Hartley, Ghaffari, Eustice, Grizzle, 2020)
/// estimates orientation, velocity, position, contact points and IMU biases from the raw gyroscope
/// and accelerometer and the leg kinematics. The filter uses the quaternion of the IMU only as
/// initial value, and instead of a gyroscope that has stopped. It also checks the quaternion. The
/// contact confidence of each foot is fused from footForceEst, footForce, joint torques and foot
/// motion. These sources are also checked against each other.
///
/// The world frame has z up; at the first sample it has the heading of the base, and the mean
/// height of the feet is zero. Position and yaw are not observable, so they drift; report() has
/// their covariance. Not thread-safe.
class StateEstimator {
 public:
  explicit StateEstimator(const Robot& robot);
  ~StateEstimator();
  StateEstimator(StateEstimator&&) noexcept;

  /// Process one sample. Real-time: yes.
  /// @param low_state IMU, joint angles, velocities and torques of motors 0 .. 11, footForce and
  /// footForceEst are read
  /// @param dt [s] since the last processed sample, 0 < dt <= 0.1
  /// @return kOk; kStaleTick (dt out of range), kNonFinite or kImplausible, with the state
  /// unchanged; kDiverged if no motion explains the samples: the estimator then starts again with
  /// the next sample. A finite quaternion that is not of unit length only lowers its own verdict in
  /// report().
  Status update(const LowState& low_state, double dt) noexcept;

  const RobotState& state() const noexcept;
  /// Return the uncertainty of the state and the verdicts on the sensors. Real-time: yes.
  EstimatorReport report() const noexcept;
  /// Compute the normal force [N] on each foot from the joint torques, FR FL RR RL. Real-time: yes.
  Eigen::Vector4d normal_forces_from_torques() const noexcept;
  /// Return whether footForceEst works on this robot: its sum has matched the load on the feet.
  /// Real-time: yes.
  bool has_foot_force_est() const noexcept;
  /// Kinematics and dynamics at the present state, for use in the same tick.
  const Dynamics& dynamics() const noexcept;

  /// Set the gains. Throws surefoot::Error and changes nothing if a gain is invalid.
  void set_gains(const Gains& gains);
  /// Set the gains within a tick. Real-time: yes.
  /// @return false if a gain is invalid; nothing changes then
  bool adopt_gains(const Gains& gains) noexcept;
  /// Set the ground normal, unit length, world axes. The contact points on the spherical feet move
  /// with it. Real-time: yes.
  void set_ground_normal(const Vector3& normal) noexcept;
  /// Set the planned motion: the motion that the command in force at the next sample was meant to
  /// cause.
  ///
  /// Measured acceleration beyond the plan is attributed to an external force, and `tau` replaces
  /// tauEst where tauEst is not usable. The plan stays in force until the next call. Without any
  /// call since the start, only the sustained external wrench is estimated. Real-time: yes.
  /// @param a_base planned acceleration of the base, Pinocchio's convention (spatial, base axes)
  /// @param tau torques of that command [N.m], SDK motor order
  /// @param f_push [N] push that the plan took into account, world axes: f_external - f_sustained
  void set_planned_motion(const Vector6& a_base, const Vector12& tau,
                          const Vector3& f_push) noexcept;
  /// Start again with the next sample. Real-time: yes.
  void reset() noexcept;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace surefoot
