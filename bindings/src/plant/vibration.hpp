// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cmath>

#include "plant/joint_and_foot_sensors.hpp"

namespace surefoot::plant {

/// Vibration of the trunk at the IMU. Each axis of gyroscope and accelerometer has one damped
/// oscillator. A change of a foot's normal force changes the oscillator's value:
///
///     d(value)/dt = -2 z w value - w^2 integral + coupling d(forces)/dt,   d(integral)/dt = value
///
/// with natural frequency w and damping ratio z. While the forces are constant, value and integral
/// decay to zero: the vibration causes no net rotation and no net velocity.
class Vibration {
 public:
  using Array6 = Eigen::Array<double, 6, 1>;
  using Coupling = Eigen::Matrix<double, 6, kLegs>;

  /// @param frequency natural frequencies [rad/s]: gyroscope x y z, accelerometer x y z
  /// @param damping_ratio damping ratio of all oscillators, above 0 and below 1
  /// @param coupling change of the six values by a change of the four normal forces [rad/s/N],
  /// [m/s^2/N]
  /// @param dt physics step [s]
  Vibration(const Array6& frequency, double damping_ratio, const Coupling& coupling, double dt)
      : coupling_(coupling) {
    const Array6 decay = damping_ratio * frequency;
    const Array6 damped = std::sqrt(1.0 - damping_ratio * damping_ratio) * frequency;
    const Array6 envelope = (-decay * dt).exp();
    const Array6 cosine = envelope * (damped * dt).cos();
    const Array6 sine = envelope * (damped * dt).sin() / damped;
    keep_integral_ = cosine + decay * sine;
    value_to_integral_ = sine;
    integral_to_value_ = -frequency.square() * sine;
    keep_value_ = cosine - decay * sine;
  }

  /// Start at rest with normal forces [N].
  void start(const Array4& forces) {
    value_ = integral_ = Array6::Zero();
    forces_ = forces;
  }

  /// Advance by one physics step; forces are the normal forces [N] at its end.
  void step(const Array4& forces) {
    // Half of the change acts at the beginning of the step and half at its end. So the sum of the
    // sampled values, too, returns to zero.
    const Array6 half_change = 0.5 * (coupling_ * (forces - forces_).matrix()).array();
    const Array6 integral = integral_, value = value_ + half_change;
    integral_ = keep_integral_ * integral + value_to_integral_ * value;
    value_ = integral_to_value_ * integral + keep_value_ * value + half_change;
    forces_ = forces;
  }

  /// Return the vibration [rad/s], [m/s^2]: gyroscope x y z, accelerometer x y z, IMU axes.
  const Array6& value() const { return value_; }

 private:
  Coupling coupling_;
  Array6 keep_integral_, value_to_integral_, integral_to_value_, keep_value_;
  Array6 value_ = Array6::Zero(), integral_ = Array6::Zero();
  Array4 forces_ = Array4::Zero();
};

}  // namespace surefoot::plant
