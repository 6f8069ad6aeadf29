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
/// and accelerometer and the leg kinematics. The IMU quaternion gives the initial orientation.
/// Later the quaternion is only checked against the filter; it replaces the gyroscope while the
/// gyroscope is faulty. The contact confidence of each foot is fused from footForceEst, footForce,
/// joint torques and foot motion. These contact sources are also checked against each other.
///
/// The world frame has z up; at the first sample it has the heading of the base, and the mean
/// height of the feet is zero. Position and yaw are not observable, so both drift; report() has the
/// covariance. Not thread-safe.
class StateEstimator {
 public:
  /// Create an estimator with RobotConfig::gains. Real-time: no.
  explicit StateEstimator(const Robot& robot);
  ~StateEstimator();
  /// Take over the content of another StateEstimator, which may only be destroyed afterwards.
  StateEstimator(StateEstimator&&) noexcept;

  /// Process one sample. Real-time: yes.
  /// @param low_state sample. Fields read: imu; q, dq and tauEst of motors 0 .. 11; footForce;
  /// footForceEst
  /// @param dt [s] time since the last processed sample, 0 < dt <= 0.1
  /// @return kOk: the sample was processed. kStaleTick (dt out of range), kNonFinite, kImplausible:
  /// the state is unchanged. kDiverged: no motion explains the samples, and the estimator starts
  /// again with the next sample. A finite quaternion that is not of unit length only changes its
  /// verdict in report().
  Status update(const LowState& low_state, double dt) noexcept;

  const RobotState& state() const noexcept;  ///< state after the last processed sample
  /// Return the uncertainty of the state and the verdicts on the sensors. Real-time: yes.
  EstimatorReport report() const noexcept;
  /// Compute the normal force [N] on each foot from the joint torques, FR FL RR RL. Real-time: yes.
  Eigen::Vector4d normal_forces_from_torques() const noexcept;
  /// Compute the depth [m] by which each sole yields under its load, FR FL RR RL, see
  /// EstimatorReport::sole_compliance. Real-time: yes.
  Eigen::Vector4d sole_sink() const noexcept;
  /// Return whether footForceEst works on this robot: its sum has matched the load on the feet.
  /// Real-time: yes.
  bool has_foot_force_est() const noexcept;
  /// Return EstimatorReport::friction without the cost of a report. Real-time: yes.
  double ground_friction() const noexcept;
  /// Return the kinematics and dynamics at the present state, for use in the same tick. Real-time:
  /// yes.
  const Dynamics& dynamics() const noexcept;

  /// Set the gains. Throws surefoot::Error and changes nothing if a gain is invalid. Real-time: no.
  void set_gains(const Gains& gains);
  /// Set the gains within a tick. Real-time: yes.
  /// @return false if a gain is invalid; nothing changes then
  bool adopt_gains(const Gains& gains) noexcept;
  /// Set the ground normal: unit length, world axes. The contact points on the spherical feet move
  /// accordingly. Real-time: yes.
  void set_ground_normal(const Vector3& normal) noexcept;
  /// Set the planned motion: the motion that should result from the command in force at the next
  /// sample.
  ///
  /// Measured acceleration beyond the plan is attributed to an external force, and `tau` replaces
  /// tauEst where tauEst is not usable. The plan stays in force until the next call. Without any
  /// call since the start, only the sustained external wrench is estimated. Real-time: yes.
  /// @param a_base planned acceleration of the base, Pinocchio's convention (spatial, base axes)
  /// @param tau [N.m] torques of that command, SDK motor order
  /// @param f_push [N] push that the plan included, world axes: f_external - f_sustained
  void set_planned_motion(const Vector6& a_base, const Vector12& tau,
                          const Vector3& f_push) noexcept;
  /// Set whether a planner lets feet step; initially false. The estimator recognises a robot that
  /// steps from its contacts too, two touchdowns late. Then it assumes the noise of the IMU instead
  /// of measuring it, and the payload stays as it was. While the planner lets feet step, it
  /// estimates no push. Real-time: yes.
  void set_stepping(bool stepping) noexcept;
  /// Discard the estimate and start again with the next sample. Real-time: yes.
  void reset() noexcept;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace surefoot
