// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "estimator/base/foot_noise.hpp"
#include "estimator/base/foot_wander.hpp"
#include "estimator/base/invariant_filter.hpp"
#include "estimator/contact/contact_belief.hpp"
#include "estimator/contact/foot_rise.hpp"
#include "estimator/contact/leg_forces.hpp"
#include "estimator/contact/slip_detector.hpp"
#include "estimator/contact/torque_health.hpp"
#include "estimator/imu/imu_reader.hpp"
#include "estimator/imu/inertial_input.hpp"
#include "estimator/imu/quaternion_check.hpp"
#include "estimator/outside/payload_observer.hpp"
#include "estimator/outside/push_observer.hpp"
#include "surefoot/state_estimator.hpp"

namespace surefoot {

/// The parts of the estimator, and the stages of its tick in their order.
struct StateEstimator::Impl {
  explicit Impl(const Robot& r);

  void read_joints(const LowState& low_state) noexcept;
  void start() noexcept;
  void align() noexcept;
  void align_anew() noexcept;
  void predict(double dt) noexcept;
  void update_dynamics() noexcept;
  void find_contacts(const LowState& low_state, double dt) noexcept;
  void correct(double dt) noexcept;
  void observe_outside(double dt) noexcept;
  void reset() noexcept;

  FootBeliefs feet_beliefs() const noexcept;
  /// [m/s^2] classical, of the base's origin, base axes, from the accelerometer.
  Vector3 base_acceleration() const noexcept;
  bool torques_tell() const noexcept { return torques.verdict() == Verdict::kGood; }
  bool carried() const noexcept;
  bool misled() const noexcept;

  Robot robot;
  Gains gains;
  Dynamics dynamics;
  ImuReader reader;
  ImuReading imu;
  InertialInput inertial;
  QuaternionCheck quaternion;
  InvariantFilter filter;
  FootNoise noise;
  FootWander wander;
  TorqueHealth torques;
  LegForces legs;
  ContactBelief contact;
  SlipDetector slip;
  FootRise rise;
  PayloadObserver payload;
  PushObserver push;

  Vector6 planned = Vector6::Zero();  // Pinocchio's axes
  Vector12 planned_tau = Vector12::Zero();
  Vector3 planned_push = Vector3::Zero();  // [N] world axes
  bool has_plan = false;
  RobotState state;
  Vector12 tau_est = Vector12::Zero();  // SDK order, as the next two
  Vector12 q = Vector12::Zero(), dq = Vector12::Zero();
  InertialStep step;
  Eigen::Vector4d loads = Eigen::Vector4d::Constant(0.25);       // shares of the weight, by torques
  Vector3 w_base = Vector3::Zero(), w_smooth = Vector3::Zero();  // [rad/s] bias taken off
  Vector3 alpha_base = Vector3::Zero();                          // [rad/s^2]
  Vector3 normal = Vector3::UnitZ();
  double way = 0.0;  // [m] that the base has travelled
  bool started = false, aligned = false;
};

/// Does the accelerometer, at rest, show the vertical that the vendor's attitude has?
bool vouch_for_each_other(const ImuReading& imu) noexcept;

}  // namespace surefoot
