// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dynamics/dynamics.hpp"
#include "estimator/base/invariant_filter.hpp"
#include "estimator/imu/imu_reader.hpp"
#include "estimator/imu/sample_noise.hpp"

namespace surefoot {

/// Turns a reading of the IMU into a step of the filter, with variances that say what it is worth.
///
/// The tick's mean is half the last sample and half this one. Their noise is measured, by second
/// differences, from the gain's value on. A held sample is wrong by the same noise again and by
/// what has changed since. A gyroscope that has stopped, or that the turn of the vendor's
/// quaternion contradicts with one voice with the legs that stand (without three of them, with the
/// rate of the tick before), is replaced by that turn while it moves, else by the legs; an
/// accelerometer that has stopped by rest. Real-time: yes.
class ImuPreprocessor {
 public:
  /// @param dynamics,contact of the tick before
  ImuInput update(const Gains& gains, const ImuReading& imu, const InvariantFilter& filter,
                  const Dynamics& dynamics, const Eigen::Vector4d& contact, double dt) noexcept;

  /// Did the others outvote the gyroscope in the last step?
  bool gyroscope_rejected() const noexcept { return gyroscope_rejected_; }
  void reset() noexcept { *this = ImuPreprocessor(); }

 private:
  bool contradicts_gyroscope(const ImuReading& imu, const InvariantFilter& filter,
                             const Dynamics& dynamics, const Eigen::Vector4d& contact,
                             bool quaternion_changed) const noexcept;
  void replace_rate(const ImuReading& imu, const InvariantFilter& filter, const Dynamics& dynamics,
                    const Eigen::Vector4d& contact, bool quaternion_changed,
                    ImuInput& out) const noexcept;

  SampleNoise w_noise_, f_noise_;
  Vector3 last_w_ = Vector3::Zero(), last_f_ = Vector3::Zero();
  Quaternion last_quaternion_ = Quaternion::Identity();  // the vendor's
  Quaternion rotation_since_last_ =
      Quaternion::Identity();         // what it was turned by since that was new
  double quaternion_age_ = 0.0;       // [s] since that was new
  bool has_last_quaternion_ = false;  // a quaternion
  bool gyroscope_rejected_ = false;
  bool started_ = false;
};

/// Rate of the base [rad/s], base axes, at which the standing feet would rest: least squares.
///
/// @return false, and w_base as it was, where fewer than three feet stand
bool rate_from_legs(const Dynamics& dynamics, const Eigen::Vector4d& contact,
                    Vector3& w_base) noexcept;

}  // namespace surefoot
