// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/external_wrench/payload_observer.hpp"

#include <algorithm>
#include <cmath>

namespace surefoot {

namespace {

// [m/s] Speed of the centre of mass below which the robot is at rest. Chosen larger than the
// velocity noise of a standing robot, and smaller than the velocity after a push.
constexpr double kRestSpeed = 0.1;
// [s] Time constant of the mean wrench at rest. Chosen. If smaller: the mean contains a larger
// share of a push that has just begun, and the robot is still slower than kRestSpeed. If larger: a
// payload that was just put on is not yet carried when the robot begins to walk.
constexpr double kRestTime = 0.5;
// [m] Bound of the estimated moment, divided by the bound of the estimated force. Chosen: a payload
// within 0.1 m of the centre of mass (docs/explanation/estimator.md, payload_max).
constexpr double kMaxLever = 0.1;

Vector3 limit_norm(const Vector3& value, double max_force) noexcept {
  const double size = value.norm();
  return size > max_force ? Vector3(max_force / size * value) : value;
}

// Return the rotation from heading axes (x forward, z up) to world axes.
Matrix3 heading(const Dynamics& dynamics) noexcept {
  const Matrix3& R = dynamics.R_world_base();
  return exp_so3(std::atan2(R(1, 0), R(0, 0)) * Vector3::UnitZ()).toRotationMatrix();
}

}  // namespace

void PayloadObserver::update(const Gains& gains, const Dynamics& dynamics, const FeetMatrix& forces,
                             bool supported, bool stepping, double dt) noexcept {
  const Vector3 linear = mass_ * dynamics.v_world_com();
  const Vector3& angular = dynamics.L_world_com();
  if (stepping) {
    force_ = force_at_rest_;
    moment_ = heading(dynamics) * moment_at_rest_;
  }
  if (stepping || !supported) {
    reset_momentum(gains, linear, angular);
    return;
  }
  Vector3 moment = Vector3::Zero();
  for (int leg = 0; leg < kLegs; ++leg) {
    const Vector3 arm = dynamics.legs()[leg].p_world_contact - dynamics.p_world_com();
    moment += arm.cross(forces.col(leg));
  }
  const Vector3 weight = -mass_ * kGravity * Vector3::UnitZ();
  const double max_force = gains.payload_max * mass_ * kGravity;
  if (!started_) {
    // If the robot is at rest at the start, the wrench follows from static equilibrium at once.
    if (dynamics.v_world_com().norm() < kRestSpeed) {
      force_ = limit_norm(-forces.rowwise().sum() - weight, max_force);
      moment_ = limit_norm(-moment, kMaxLever * max_force);
      force_at_rest_ = force_;
      moment_at_rest_ = heading(dynamics).transpose() * moment_;
    }
    reset_momentum(gains, linear, angular);
    started_ = true;
    return;
  }
  linear_momentum_ += dt * (forces.rowwise().sum() + weight + force_);
  angular_momentum_ += dt * (moment + moment_);
  force_ = limit_norm((linear - linear_momentum_) / gains.payload_time, max_force);
  moment_ = limit_norm((angular - angular_momentum_) / gains.payload_time, kMaxLever * max_force);
  reset_momentum(gains, linear, angular);
  average_at_rest(dynamics, dt);
}

void PayloadObserver::average_at_rest(const Dynamics& dynamics, double dt) noexcept {
  if (dynamics.v_world_com().norm() > kRestSpeed) return;
  const double share = dt / (dt + kRestTime);
  force_at_rest_ += share * (force_ - force_at_rest_);
  moment_at_rest_ += share * (heading(dynamics).transpose() * moment_ - moment_at_rest_);
}

// Set the predicted momentum to the value with which the present momentum gives the present
// estimate of the wrench again. This prevents wind-up at the bounds, and a transient after a time
// without support.
void PayloadObserver::reset_momentum(const Gains& gains, const Vector3& linear,
                                     const Vector3& angular) noexcept {
  linear_momentum_ = linear - gains.payload_time * force_;
  angular_momentum_ = angular - gains.payload_time * moment_;
}

// A payload of mass m_p at r from the model's centre of mass causes the moment N = r x (-m_p g z).
// It shifts the centre of mass by m_p r / (m + m_p).
Vector3 PayloadObserver::com_shift() const noexcept {
  // Numerical: under an external lift the estimated payload can be -mass_, and the total mass 0.
  const double total = std::max(mass_ + mass(), 0.1 * mass_);
  return Vector3(moment_.y(), -moment_.x(), 0.0) / (kGravity * total);
}

}  // namespace surefoot
