// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dynamics/dynamics.hpp"
#include "estimator/filter/invariant_filter.hpp"
#include "estimator/imu/imu_reader.hpp"
#include "estimator/imu/noise_estimator.hpp"

namespace surefoot {

/// What the feet do, as far as the IMU feels it.
struct FeetState {
  const Eigen::Vector4d& contact;  ///< contact confidences, 0 .. 1
  bool step;                       ///< feet step, so impacts vibrate in the IMU
  bool rest;                       ///< all feet stand; only then the noise of the IMU is learnt
  bool off_ground = false;  ///< no foot stands, so none corrects the rotation by the gyroscope
};

/// Converts IMU readings to filter inputs: mean angular rate and specific force over the tick, and
/// their variances.
///
/// The mean is the average of the last and the present sample. NoiseEstimator measures the noise of
/// the samples, starting from the gains noise_gyroscope and noise_accelerometer. Repeated values
/// get a larger variance.
///
/// The gyroscope is replaced if its verdict is bad, or if the IMU quaternion and the stance legs
/// agree with each other but contradict the gyroscope. (With fewer than three stance feet, this
/// comparison uses the last rate instead of the rate from the legs.) The replacement is the rate of
/// the quaternion if the quaternion has changed and has not jumped. Otherwise the replacement is
/// the rate from the legs, or zero with a large variance if there are fewer than three stance feet.
/// An accelerometer with a bad verdict is replaced by the specific force of a body at rest, which
/// is gravity alone. Real-time: yes.
class ImuFilterInput {
 public:
  /// Compute the filter input of this tick.
  /// @param dynamics dynamics of the last tick
  /// @param feet feet in the last tick
  ImuInput update(const Gains& gains, const ImuReading& imu, const InvariantFilter& filter,
                  const Dynamics& dynamics, const FeetState& feet, double dt) noexcept;

  /// Return whether the last update() rejected the gyroscope.
  bool gyroscope_rejected() const noexcept { return gyroscope_rejected_; }
  void reset() noexcept { *this = ImuFilterInput(); }

 private:
  bool contradicts_gyroscope(const ImuReading& imu, const InvariantFilter& filter,
                             const Dynamics& dynamics, const Eigen::Vector4d& contact,
                             bool quaternion_changed) const noexcept;
  void replace_rate(const ImuReading& imu, const InvariantFilter& filter, const Dynamics& dynamics,
                    const Eigen::Vector4d& contact, bool quaternion_changed,
                    ImuInput& out) const noexcept;

  NoiseEstimator w_noise_, f_noise_;
  Vector3 last_w_ = Vector3::Zero(), last_f_ = Vector3::Zero();
  Vector3 f_change_ = Vector3::Zero();                   // [m/s^2] last change of the accelerometer
  Quaternion last_quaternion_ = Quaternion::Identity();  // last quaternion of the IMU
  // Rotation that the filter has applied since the quaternion last changed.
  Quaternion rotation_since_last_ = Quaternion::Identity();
  double quaternion_age_ = 0.0;       // [s] time since the quaternion last changed
  bool has_last_quaternion_ = false;  // true if the last sample had a valid quaternion
  bool gyroscope_rejected_ = false;
  bool started_ = false;
};

/// Compute the turn of the stance feet about each other, by least squares; zero for feet at rest.
///
/// @param motion velocities or small displacements of the contact points, world axes
/// @param turn result: rate or angle of the turn, world axes
/// @return false with fewer than three stance feet or a singular fit
bool turn_of_feet(const Dynamics& dynamics, const Eigen::Vector4d& contact,
                  const FeetMatrix& motion, Vector3& turn) noexcept;

/// Compute the angular velocity of the base at which the stance feet are at rest, by least squares.
/// @param w_base result: angular velocity, base axes [rad/s]
/// @return false if there are fewer than three stance feet or the fit is singular; w_base then
///   stays unchanged
bool rate_from_legs(const Dynamics& dynamics, const Eigen::Vector4d& contact,
                    Vector3& w_base) noexcept;

}  // namespace surefoot
