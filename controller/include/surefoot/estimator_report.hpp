// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string_view>

#include "surefoot/math.hpp"

namespace surefoot {

/// What a sensor is worth at present.
enum class SensorVerdict : int {
  kGood = 0,
  kUnjudged,    ///< nothing has happened yet that could tell
  kZero,        ///< reads exactly zero
  kConstant,    ///< stands still while the robot moves
  kSaturated,   ///< at the end of its range
  kDisagrees,   ///< contradicts the others
  kImplausible  ///< beyond what it can measure
};
const char* to_string(SensorVerdict verdict) noexcept;

/// What tells of a foot's contact.
enum class ContactSource : int {
  kFootForceEst = 0,  ///< newtons
  kFootForce,         ///< raw counts, by their change
  kTauEst,            ///< force from the leg's joint torques
  kNoSlip             ///< a foot that moves does not stand
};
constexpr int kContactSources = 4;
const char* to_string(ContactSource source) noexcept;

/// What the estimator knows beyond the state: how sure it is, and what it thinks of its sensors.
struct EstimatorReport {
  /// IMU fields by their names in LowState.
  SensorVerdict gyroscope = SensorVerdict::kUnjudged;
  SensorVerdict accelerometer = SensorVerdict::kUnjudged;
  SensorVerdict quaternion = SensorVerdict::kUnjudged;
  /// Contact sources [source][leg], FR FL RR RL.
  std::array<std::array<SensorVerdict, kLegs>, kContactSources> contact_sources{};
  /// What each source alone says, shape (source, leg): probability 0 .. 1; 0.5 if it says nothing.
  Eigen::Matrix<double, kContactSources, kLegs> contact_by_source =
      Eigen::Matrix<double, kContactSources, kLegs>::Constant(0.5);
  /// Force of the ground on each foot, from joint torques, world axes [N].
  FeetMatrix foot_forces_from_torques = FeetMatrix::Zero();
  /// How surely a standing foot slips, 0 .. 1.
  Eigen::Vector4d slip = Eigen::Vector4d::Zero();

  Vector3 gyroscope_bias = Vector3::Zero();      ///< [rad/s] base axes
  Vector3 accelerometer_bias = Vector3::Zero();  ///< [m/s^2] base axes
  /// Covariance of the errors (estimate less truth) of rotation (world axes) [rad], v_world of the
  /// base [m/s], p_world of the base [m], gyroscope_bias, accelerometer_bias.
  Eigen::Matrix<double, 15, 15> covariance = Eigen::Matrix<double, 15, 15>::Zero();
  /// Normalised innovation squared of the feet taken in by the last update, and its dimension.
  double nis = 0.0;
  int nis_dimension = 0;
  std::array<bool, kLegs> rejected_feet{};  ///< feet that the innovation gate refused

  /// [N], [N.m] from outside on the robot, about its centre of mass, world axes: slow part.
  Vector3 force_external = Vector3::Zero();
  Vector3 moment_external = Vector3::Zero();
  double payload = 0.0;                 ///< [kg] more than the model has
  Vector3 com_shift = Vector3::Zero();  ///< [m] of the centre of mass, model to loaded, base axes
};

}  // namespace surefoot
