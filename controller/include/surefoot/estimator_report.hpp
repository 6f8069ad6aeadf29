// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string_view>

#include "surefoot/math.hpp"

namespace surefoot {

/// What the estimator concludes about a sensor.
enum class SensorVerdict : int {
  kGood = 0,    ///< used
  kUnjudged,    ///< not judged yet: the samples so far do not suffice
  kZero,        ///< reads exactly zero
  kConstant,    ///< constant while other fields of the samples change
  kSaturated,   ///< at the end of its range
  kDisagrees,   ///< contradicts the other sensors
  kImplausible  ///< beyond what it can measure
};
/// Return the name of a verdict, such as "good". Real-time: yes.
const char* to_string(SensorVerdict verdict) noexcept;

/// Measurement that shows whether a foot is on the ground.
enum class ContactSource : int {
  kFootForceEst = 0,  ///< LowState::footForceEst [N]
  kFootForce,         ///< LowState::footForce: raw counts, calibrated against the other sources
  kTauEst,            ///< foot force computed from the joint torques of the leg
  kFootMotion         ///< motion of the foot: a foot that rises or moves fast is off the ground
};
constexpr int kContactSources = 4;
/// Return the name of a source. Real-time: yes.
const char* to_string(ContactSource source) noexcept;

/// Uncertainty of the state estimate, and the estimator's view of its sensors. Feet and legs run
/// FR FL RR RL. Plain data.
struct EstimatorReport {
  /// Verdicts on the IMU fields of LowState.
  SensorVerdict gyroscope = SensorVerdict::kUnjudged;
  SensorVerdict accelerometer = SensorVerdict::kUnjudged;
  SensorVerdict quaternion = SensorVerdict::kUnjudged;
  /// Verdicts on the contact sources, [ContactSource][leg].
  std::array<std::array<SensorVerdict, kLegs>, kContactSources> contact_sources{};
  /// Evidence of each source alone, shape (source, leg). 0: off the ground; 1: loaded; 0.5: no
  /// evidence, or balanced.
  Eigen::Matrix<double, kContactSources, kLegs> contact_by_source =
      Eigen::Matrix<double, kContactSources, kLegs>::Constant(0.5);
  /// Force of the ground on each foot by the joint torques, world axes [N]: a generalised-momentum
  /// observer (De Luca, Mattone 2003).
  FeetMatrix foot_forces_from_torques = FeetMatrix::Zero();
  /// How sure the estimator is that a loaded foot slips, 0 .. 1.
  Eigen::Vector4d slip = Eigen::Vector4d::Zero();

  Vector3 gyroscope_bias = Vector3::Zero();      ///< [rad/s] base axes
  Vector3 accelerometer_bias = Vector3::Zero();  ///< [m/s^2] base axes
  /// Covariance of the errors (estimate minus truth), in this order: rotation of the base (world
  /// axes) [rad], its velocity [m/s] and position [m] in the world, gyroscope_bias,
  /// accelerometer_bias.
  Eigen::Matrix<double, 15, 15> covariance = Eigen::Matrix<double, 15, 15>::Zero();
  /// Normalised innovation squared of the foot measurements in the last update, and its dimension.
  double nis = 0.0;
  int nis_dimension = 0;
  std::array<bool, kLegs> rejected_feet{};  ///< feet that the innovation gate rejected

  /// Sustained external wrench: force [N] and moment about the centre of mass [N.m], world axes.
  Vector3 f_sustained = Vector3::Zero();
  Vector3 moment_external = Vector3::Zero();
  double payload = 0.0;                 ///< [kg] mass beyond the model; may be negative
  Vector3 com_shift = Vector3::Zero();  ///< [m] centre of mass, loaded minus model, base axes
};

}  // namespace surefoot
