// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "surefoot/estimator_report.hpp"
#include "surefoot/robot.hpp"
#include "surefoot/types.hpp"

namespace surefoot {

class Dynamics;

/// LowState in, RobotState out: what the robot's own sensors say about its base and its contacts.
///
/// Raw gyroscope and accelerometer and the legs' kinematics drive a contact-aided invariant Kalman
/// filter (orientation, velocity, position, contact points, biases); the IMU's own quaternion only
/// starts it, cross-checks it, and stands in for a gyroscope that has stopped. Contact is a belief
/// per foot, fused from footForceEst, footForce, joint torques and the feet's own motion, each
/// judged by the others. The world frame starts with the base's heading, the feet at height zero,
/// and drifts in x, y, z and yaw, as it must; report() says by how much. Real-time: update() yes.
class StateEstimator {
 public:
  explicit StateEstimator(const Robot& robot);
  ~StateEstimator();
  StateEstimator(StateEstimator&&) noexcept;

  /// Take in one report. @param dt [s] since the last one taken in, 0 < dt <= 0.1
  /// @return kOk; kStaleTick (dt), kNonFinite or kImplausible with the state as it was; kDiverged,
  /// after reports that no motion explains: it begins anew with the next. A quaternion of finite
  /// numbers that is none only counts against itself: see report().
  Status update(const LowState& low_state, double dt) noexcept;

  const RobotState& state() const noexcept;
  /// How sure the state is, and what the sensors are worth. Real-time: yes.
  EstimatorReport report() const noexcept;
  /// Normal force per foot from the motors' torques [N].
  Eigen::Vector4d normal_forces_from_torques() const noexcept;
  /// Does footForceEst carry anything?
  bool has_foot_force_est() const noexcept;
  /// Pinocchio's terms at the present state, for whoever needs them in the same tick.
  const Dynamics& dynamics() const noexcept;

  /// Throws surefoot::Error and changes nothing if a gain is invalid.
  void set_gains(const Gains& gains);
  /// The same in the tick. @return false, and nothing is changed, if one is invalid. Real-time:
  /// yes.
  bool adopt_gains(const Gains& gains) noexcept;
  /// The ground's normal as the contacts know it; unit, world axes.
  void set_ground_normal(const Vector3& normal) noexcept;
  /// What the command that the next report tells of was to make of the base, in Pinocchio's axes,
  /// and its torques [N.m], SDK motor order. What the accelerometer feels beyond the plan is laid
  /// to a force from outside; the torques stand in where tauEst tells nothing. No plan if never
  /// told.
  /// @param f_push [N] that the plan counted with, world axes: f_external - f_sustained of its
  /// state
  void set_planned_motion(const Vector6& a_base, const Vector12& tau,
                          const Vector3& f_push) noexcept;
  /// Begin anew with the next report.
  void reset() noexcept;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace surefoot
