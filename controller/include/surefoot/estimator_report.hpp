// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string_view>

#include "surefoot/math.hpp"

namespace surefoot {

/// What the estimator concludes about a sensor.
enum class SensorVerdict : int {
  kGood = 0,    ///< the estimator uses the sensor
  kUnjudged,    ///< not judged yet: there are too few samples
  kZero,        ///< the sensor reads exactly zero
  kConstant,    ///< the reading stays the same while other fields of the samples change
  kSaturated,   ///< the reading is at the end of the sensor's range
  kDisagrees,   ///< the reading contradicts the other sensors
  kImplausible  ///< the reading is beyond what the sensor can measure
};
/// Return the name of a verdict, such as "good". Real-time: yes.
const char* to_string(SensorVerdict verdict) noexcept;

/// Measurement that shows whether a foot is on the ground.
enum class ContactSource : int {
  kFootForceEst = 0,  ///< LowState::footForceEst [N]
  kFootForce,         ///< LowState::footForce: raw counts, calibrated against the other sources
  kTauEst,            ///< foot force computed from the joint torques of the leg
  kFootMotion         ///< foot motion: a foot that rises or moves fast is off the ground
};
constexpr int kContactSources = 4;  ///< number of contact sources
/// Return the name of a source, such as "footForce". Real-time: yes.
const char* to_string(ContactSource source) noexcept;

/// Uncertainty of the state estimate, and verdicts on the sensors. Arrays over feet or legs are in
/// leg order: FR FL RR RL. Plain data.
struct EstimatorReport {
  SensorVerdict gyroscope = SensorVerdict::kUnjudged;      ///< verdict on IMU::gyroscope
  SensorVerdict accelerometer = SensorVerdict::kUnjudged;  ///< verdict on IMU::accelerometer
  SensorVerdict quaternion = SensorVerdict::kUnjudged;     ///< verdict on IMU::quaternion
  /// Verdicts on the contact sources, [ContactSource][leg].
  std::array<std::array<SensorVerdict, kLegs>, kContactSources> contact_sources{};
  /// Contact evidence of each source alone, shape (4, 4): row ContactSource, column leg. 0: off the
  /// ground; 1: loaded; 0.5: no evidence, or evidence for both.
  Eigen::Matrix<double, kContactSources, kLegs> contact_by_source =
      Eigen::Matrix<double, kContactSources, kLegs>::Constant(0.5);
  /// [N] Ground force on each foot, computed from the joint torques, world axes. Method:
  /// generalised-momentum observer (De Luca, Mattone 2003).
  FeetMatrix foot_forces_from_torques = FeetMatrix::Zero();
  /// How sure the estimator is that a loaded foot slips, 0 .. 1.
  Eigen::Vector4d slip = Eigen::Vector4d::Zero();
  /// Friction coefficient of the ground, learnt from feet that slide and hold. Initially
  /// RobotConfig::friction, and never more; at least 0.1.
  double friction = 0.0;
  /// Rotor inertia of each joint, learnt from legs that swing [kg.m^2], SDK motor order. Initially
  /// RobotConfig::armature.
  Vector12 armature = Vector12::Zero();
  /// Viscous friction of each joint, learnt from legs that swing [N.m.s/rad], SDK motor order.
  /// Initially 0.
  Vector12 joint_damping = Vector12::Zero();
  /// Coulomb friction of each joint, learnt from legs that swing [N.m], SDK motor order. Initially
  /// 0.
  Vector12 joint_friction = Vector12::Zero();

  Vector3 gyroscope_bias = Vector3::Zero();      ///< [rad/s] bias of the gyroscope, base axes
  Vector3 accelerometer_bias = Vector3::Zero();  ///< [m/s^2] bias of the accelerometer, base axes
  /// Covariance of the errors (estimate minus truth). Order: rotation [rad], velocity [m/s] and
  /// position [m] of the base, all in world axes; gyroscope_bias; accelerometer_bias.
  Eigen::Matrix<double, 15, 15> covariance = Eigen::Matrix<double, 15, 15>::Zero();
  double nis = 0.0;       ///< normalised innovation squared of the foot measurements, last update
  int nis_dimension = 0;  ///< dimension of nis: 3 for each foot that was used
  std::array<bool, kLegs> rejected_feet{};  ///< true: the innovation gate rejected the foot
  /// [m] Depth by which a sole would yield under the weight of the robot; 0 for rigid soles.
  double sole_compliance = 0.0;

  Vector3 f_sustained = Vector3::Zero();  ///< [N] sustained external force, world axes
  /// [N.m] Sustained external moment about the centre of mass, world axes.
  Vector3 moment_external = Vector3::Zero();
  double payload = 0.0;  ///< [kg] mass of the robot minus mass of the model; may be negative
  /// [m] Shift of the centre of mass against the model, caused by the payload, base axes.
  Vector3 com_shift = Vector3::Zero();
};

}  // namespace surefoot
