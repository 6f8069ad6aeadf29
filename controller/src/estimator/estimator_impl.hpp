// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "estimator/contact/contact_confidence.hpp"
#include "estimator/contact/foot_clearance.hpp"
#include "estimator/contact/friction_estimate.hpp"
#include "estimator/contact/joint_estimate.hpp"
#include "estimator/contact/leg_forces.hpp"
#include "estimator/contact/slip_detector.hpp"
#include "estimator/contact/sole_load.hpp"
#include "estimator/contact/standing_check.hpp"
#include "estimator/contact/step_detector.hpp"
#include "estimator/contact/torque_check.hpp"
#include "estimator/external_wrench/payload_observer.hpp"
#include "estimator/external_wrench/push_observer.hpp"
#include "estimator/filter/attitude_memory.hpp"
#include "estimator/filter/foot_motion_model.hpp"
#include "estimator/filter/foot_noise.hpp"
#include "estimator/filter/invariant_filter.hpp"
#include "estimator/imu/imu_filter_input.hpp"
#include "estimator/imu/imu_reader.hpp"
#include "estimator/imu/quaternion_tilt_check.hpp"
#include "surefoot/state_estimator.hpp"

namespace surefoot {

/// Components of the estimator, and the steps of its tick.
///
/// StateEstimator::update() calls, in this order: read_joints(), imu_reader.read(),
/// torque_check.update(), initialise() (first sample only), predict(), update_dynamics(),
/// update_contacts(), correct() and observe_external_wrench(). update_contacts() calls
/// check_standing(); correct() calls correct_off_ground(), align(), and restart_alignment() if the
/// attitude has diverged.
struct StateEstimator::Impl {
  explicit Impl(const Robot& r);

  void read_joints(const LowState& low_state) noexcept;
  void initialise() noexcept;
  void align() noexcept;
  void restart_alignment() noexcept;
  void predict(double dt) noexcept;
  void update_dynamics() noexcept;
  void check_standing(double dt) noexcept;
  void update_contacts(const LowState& low_state, double dt) noexcept;
  void learn_joints(const FeetMatrix& v_contact, const Vector12& stops, double dt) noexcept;
  void correct(double dt) noexcept;
  void correct_off_ground(double dt) noexcept;
  void observe_external_wrench(double dt) noexcept;
  void reset() noexcept;

  FootContactState foot_contact_state() const noexcept;
  /// Return an upper bound of the velocity error that is nearly always right [m/s].
  double velocity_error() const noexcept;
  /// Compute the measured classical acceleration [m/s^2] of the base origin, without gravity, base
  /// axes, from the accelerometer minus its estimated bias.
  Vector3 base_acceleration() const noexcept;
  bool torques_valid() const noexcept { return torque_check.verdict() == SensorVerdict::kGood; }
  bool supported() const noexcept;
  Eigen::Vector4d sole_sink() const noexcept { return filter.sole_compliance() * sole_load.load(); }
  /// Return whether the IMU has measured the motion of this tick.
  bool imu_is_fresh() const noexcept { return imu.w_age == 1 && imu.f_age <= 2; }
  /// Return whether the robot has been without contact for longer than a jump lasts.
  bool off_ground() const noexcept;
  bool attitude_diverged() const noexcept;

  Robot robot;
  Gains gains;
  Dynamics dynamics;
  ImuReader imu_reader;
  ImuReading imu;
  ImuFilterInput imu_filter_input;
  QuaternionTiltCheck quaternion_check;
  InvariantFilter filter;
  FootNoise foot_noise;
  FootMotionModel foot_motion;
  TorqueCheck torque_check;
  LegForces leg_forces;
  ContactConfidence contact;
  SoleLoad sole_load;
  StandingCheck standing_check;
  AttitudeMemory attitude_memory;
  StepDetector step_detector;
  SlipDetector slip;
  FrictionEstimate friction;
  JointEstimate joints;
  FootClearance clearance;
  PayloadObserver payload;
  PushObserver push;

  Vector6 planned_acceleration = Vector6::Zero();  // spatial, base axes [m/s^2], [rad/s^2]
  Vector12 planned_tau = Vector12::Zero();         // [N.m] SDK motor order
  Vector3 planned_push = Vector3::Zero();  // [N] world axes; the push that the plan includes
  bool has_plan = false;
  RobotState state;
  Vector12 tau_est = Vector12::Zero();  // [N.m]; tau_est, q and dq are in SDK motor order
  Vector12 q = Vector12::Zero(), dq = Vector12::Zero();
  ImuInput imu_input;
  // Normal force of each foot divided by the robot's weight, computed from the joint torques.
  Eigen::Vector4d loads = Eigen::Vector4d::Constant(0.25);
  // [rad/s] Base axes, bias removed; low-passed.
  Vector3 w_base = Vector3::Zero(), w_filtered = Vector3::Zero();
  Vector3 alpha_base = Vector3::Zero();  // [rad/s^2] base axes
  Vector3 normal = Vector3::UnitZ();     // ground normal, world axes
  double air_time = 0.0;                 // [s] for which no foot has been in contact
  double path_length = 0.0;              // [m] length of the base's path
  bool started = false, aligned = false;
};

/// Return whether the accelerometer measures gravity alone, in the vertical direction that the IMU
/// quaternion gives.
bool accelerometer_matches_quaternion(const ImuReading& imu) noexcept;

}  // namespace surefoot
