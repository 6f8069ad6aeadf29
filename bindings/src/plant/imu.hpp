// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "plant/normal_samples.hpp"
#include "plant/vibration.hpp"

namespace surefoot::plant {

using Vector3 = Eigen::Vector3d;
using Wxyz = Eigen::Vector4d;

/// Model of the vendor's attitude filter. It integrates the gyroscope and corrects the tilt towards
/// gravity. Yaw is not corrected, so yaw drifts. Source: R. Mahony, T. Hamel, J.-M.
/// Pflimlin, "Nonlinear complementary filters on the special orthogonal group", IEEE TAC 53(5),
/// 2008: the explicit filter without bias estimate.
class MahonyFilter {
 public:
  /// Start with the tilt that the accelerometer reading `a` gives at rest, and with yaw 0.
  /// @param a specific force, IMU axes [m/s^2]
  /// @param gain gain of the tilt correction [1/s]
  MahonyFilter(const Vector3& a, double gain) : gain_(gain) {
    const double roll = std::atan2(a.y(), a.z());
    const double pitch = std::atan2(-a.x(), std::hypot(a.y(), a.z()));
    const double cr = std::cos(roll / 2), sr = std::sin(roll / 2);
    const double cp = std::cos(pitch / 2), sp = std::sin(pitch / 2);
    quaternion = {cr * cp, sr * cp, cr * sp, -sr * sp};
  }

  Wxyz quaternion;  ///< IMU to world, w x y z

  /// Advance by dt [s] with angular velocity [rad/s] and specific force [m/s^2], IMU axes.
  void update(Vector3 gyro, const Vector3& accel, double dt) {
    const double w = quaternion[0], x = quaternion[1], y = quaternion[2], z = quaternion[3];
    const double norm = accel.norm();
    // Threshold in m/s^2: in free fall the accelerometer does not show the vertical.
    if (norm > 1e-6) {
      // Correction: cross product of measured and estimated up, both in IMU axes.
      const Vector3 up(2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y));
      const Vector3& a = accel;
      gyro += gain_ / norm *
              Vector3(a.y() * up.z() - a.z() * up.y(), a.z() * up.x() - a.x() * up.z(),
                      a.x() * up.y() - a.y() * up.x());
    }
    const double h = 0.5 * dt, gx = gyro.x(), gy = gyro.y(), gz = gyro.z();
    quaternion = {w - h * (x * gx + y * gy + z * gz), x + h * (w * gx + y * gz - z * gy),
                  y + h * (w * gy - x * gz + z * gx), z + h * (w * gz + x * gy - y * gx)};
    quaternion.normalize();
  }

 private:
  double gain_;  // [1/s]
};

/// Addresses of the exact readings at the site of the IMU, in MuJoCo's memory.
struct ImuSite {
  const double *gyro, *accelerometer, *quaternion;
};

/// Errors of a real IMU: constant bias, white noise, range, and a sample period of several physics
/// steps.
struct ImuErrorModel {
  Vector3 gyro_bias, accelerometer_bias;   // [rad/s], [m/s^2], IMU axes
  double gyro_noise, accelerometer_noise;  // standard deviations of a sample, same units
  int steps;                               // number of physics steps per sample
  double period;                           // [s] sample period
  double filter_gain;                      // [1/s] gain of the attitude filter
  double gyro_range, accelerometer_range;  // [rad/s], [m/s^2]; values clip at +- range
};

/// Simulated IMU: exact, or with bias, noise and the vendor's attitude filter.
class Imu {
 public:
  explicit Imu(const ImuSite& site) : site_(site), filter_({0, 0, 9.81}, 0.0) {}
  Imu(const ImuSite& site, const ImuErrorModel& flaws, nb::object rng)
      : site_(site),
        flaws_(flaws),
        noise_(std::move(rng)),
        real_(true),
        filter_({0, 0, 9.81}, flaws.filter_gain) {}

  /// Start the filter with the robot at rest. The accelerometer has its bias but no noise, because
  /// a real filter has averaged out the noise at this time.
  void start() {
    if (real_)
      filter_ = {vector(site_.accelerometer) + flaws_.accelerometer_bias, flaws_.filter_gain};
  }

  /// Advance by one physics step. At the end of each sample period, measure and update the filter.
  /// @param vibration present vibration; nullptr: none
  void step(const Vibration* vibration) {
    if (!real_ || ++count_ % flaws_.steps != 0) return;
    const auto draw = [this](double deviation) {
      const double x = noise_.next(), y = noise_.next(), z = noise_.next();
      return Vector3(deviation * Vector3(x, y, z));
    };
    gyro_ = vector(site_.gyro) + flaws_.gyro_bias + draw(flaws_.gyro_noise);
    accelerometer_ =
        vector(site_.accelerometer) + flaws_.accelerometer_bias + draw(flaws_.accelerometer_noise);
    if (vibration != nullptr) {
      gyro_ += vibration->value().head<3>().matrix();
      accelerometer_ += vibration->value().tail<3>().matrix();
    }
    clip(gyro_, flaws_.gyro_range);
    clip(accelerometer_, flaws_.accelerometer_range);
    filter_.update(gyro_, accelerometer_, flaws_.period);
  }

  Vector3 gyro() const { return real_ ? gyro_ : vector(site_.gyro); }
  Vector3 accelerometer() const { return real_ ? accelerometer_ : vector(site_.accelerometer); }
  Wxyz quaternion() const {
    return real_ ? filter_.quaternion : Wxyz(Eigen::Map<const Wxyz>(site_.quaternion));
  }

 private:
  static Vector3 vector(const double* values) { return Eigen::Map<const Vector3>(values); }
  static void clip(Vector3& values, double range) {
    for (double& value : values) value = std::clamp(value, -range, range);
  }

  ImuSite site_;
  ImuErrorModel flaws_{};
  NormalSamples noise_{nb::none()};
  bool real_ = false;
  MahonyFilter filter_;
  Vector3 gyro_ = Vector3::Zero(), accelerometer_ = Vector3::Zero();
  int count_ = 0;
};

}  // namespace surefoot::plant
