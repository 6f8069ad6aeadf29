// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>

#include "plant/motors.hpp"
#include "plant/normal_samples.hpp"

namespace surefoot::plant {

/// Simulated joint encoders. Angles are quantised. Velocities pass the low-pass filter of a motor
/// driver and get white noise. If the quantum is 0, angles and velocities are exact.
class Encoders {
 public:
  /// @param quantum step of the angles [rad]; 0: exact
  /// @param share share by which the velocity filter approaches its input in a physics step, 0 .. 1
  /// @param noise standard deviation of the velocities [rad/s]
  /// @param rng numpy.random.Generator
  Encoders(double quantum, double share, double noise, nb::object rng)
      : quantum_(quantum), filter_blend_(share), noise_std_(noise), noise_(std::move(rng)) {}

  /// Advance the filter by one physics step with the true velocities [rad/s].
  void step(const Array12& dq) { filtered_ += filter_blend_ * (dq - filtered_); }

  /// Return the measured angles [rad] for the true angles q.
  Array12 angles(const Array12& q) const {
    if (quantum_ == 0.0) return q;
    return q.unaryExpr([this](double x) { return std::nearbyint(x / quantum_) * quantum_; });
  }
  /// Return the measured velocities [rad/s]. The true velocities dq [rad/s] are returned if the
  /// quantum is 0.
  Array12 velocities(const Array12& dq) {
    if (quantum_ == 0.0) return dq;
    Array12 out;
    for (int i = 0; i < kMotors; ++i) out[i] = filtered_[i] + noise_std_ * noise_.next();
    return out;
  }

 private:
  double quantum_, filter_blend_, noise_std_;  // [rad], 1, [rad/s]
  NormalSamples noise_;
  Array12 filtered_ = Array12::Zero();
};

using Array4 = Eigen::Array<double, kLegs, 1>;
using Counts = Eigen::Array<std::int16_t, kLegs, 1>;

/// Simulated foot force sensors: footForce in counts, with drifting offset, gain and noise;
/// footForceEst in newtons, with noise. Both may fall late after a force has fallen.
class FootSensors {
 public:
  bool counts_enabled = false, newtons_enabled = false;   ///< false: the field has zeros
  Array4 offset = Array4::Zero(), gain = Array4::Ones();  ///< counts, counts/N
  /// Random walk of the offset [counts per reading]; noise [counts]; noise [N].
  double offset_walk = 0.0, count_noise = 0.0, force_noise = 0.0;
  /// Share by which the measured force approaches a smaller force in a physics step, 0 .. 1. It
  /// follows a larger force at once.
  double fall_blend = 1.0;

  /// @param rng numpy.random.Generator; None: exact newtons in both fields
  explicit FootSensors(nb::object rng) : exact_(rng.is_none()), noise_(std::move(rng)) {}

  /// Start with normal forces [N] that have been constant.
  void start(const Array4& normal_forces) { falling_ = normal_forces; }

  /// Advance by one physics step; normal_forces are the forces [N] at its end.
  void step(const Array4& normal_forces) {
    falling_ = normal_forces.max(falling_ + fall_blend * (normal_forces - falling_));
  }

  /// Return footForce [counts] and footForceEst [N] for normal forces [N].
  std::pair<Counts, Counts> read(const Array4& true_forces) {
    const Array4 normal_forces = fall_blend < 1.0 ? true_forces.max(falling_) : true_forces;
    std::pair<Counts, Counts> out{Counts::Zero(), Counts::Zero()};
    if (!counts_enabled && !newtons_enabled) return out;
    Array4 counts = normal_forces, newtons = normal_forces;
    if (!exact_) {
      offset += offset_walk * draw();
      counts = offset + gain * normal_forces + count_noise * draw();
      newtons += force_noise * draw();
    }
    if (counts_enabled) out.first = to_counts(counts);
    if (newtons_enabled) out.second = to_counts(newtons);
    return out;
  }

 private:
  Array4 draw() {
    Array4 out;
    for (int leg = 0; leg < kLegs; ++leg) out[leg] = noise_.next();
    return out;
  }
  // Round and saturate, because LowState has int16 foot forces.
  static Counts to_counts(const Array4& values) {
    return values.unaryExpr([](double x) { return std::nearbyint(x); })
        .max(-32768.0)
        .min(32767.0)
        .cast<std::int16_t>();
  }

  bool exact_;
  NormalSamples noise_;
  Array4 falling_ = Array4::Zero();  // [N] force that the sensor measures
};

}  // namespace surefoot::plant
