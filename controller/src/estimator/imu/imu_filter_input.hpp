// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dynamics/dynamics.hpp"
#include "estimator/filter/invariant_filter.hpp"
#include "estimator/imu/imu_reader.hpp"
#include "estimator/imu/noise_estimator.hpp"

namespace surefoot {

/// Converts IMU readings to filter inputs: means over the tick and their variances.
///
/// The mean is the average of the last and the present sample. NoiseEstimator measures the noise of
/// the samples, starting from the gains. Repeated samples get a larger variance.
///
/// The gyroscope is replaced when its verdict is bad. It is also replaced when the IMU quaternion
/// and the stance legs agree with each other but contradict the gyroscope; with fewer than three
/// stance feet the last rate is used instead of the rate from the legs. The replacement is the rate
/// of the quaternion if the quaternion has changed. Otherwise it is the rate from the legs, and
/// with fewer than three stance feet zero with a large variance. An accelerometer with a bad
/// verdict is replaced by gravity, as at rest. Real-time: yes.
class ImuFilterInput {
 public:
  /// Compute the filter input of this tick.
  /// @param dynamics dynamics of the last tick
  /// @param contact contact confidences of the last tick, 0 .. 1
  ImuInput update(const Gains& gains, const ImuReading& imu, const InvariantFilter& filter,
                  const Dynamics& dynamics, const Eigen::Vector4d& contact, double dt) noexcept;

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
  Quaternion last_quaternion_ = Quaternion::Identity();  // of the IMU
  // Rotation that the filter has applied since the quaternion last changed.
  Quaternion rotation_since_last_ = Quaternion::Identity();
  double quaternion_age_ = 0.0;       // [s] since the quaternion last changed
  bool has_last_quaternion_ = false;  // the last sample had a valid quaternion
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
///
/// @param w_base result: angular velocity, base axes [rad/s]
/// @return false with fewer than three stance feet or a singular fit; w_base is then unchanged
bool rate_from_legs(const Dynamics& dynamics, const Eigen::Vector4d& contact,
                    Vector3& w_base) noexcept;

}  // namespace surefoot
