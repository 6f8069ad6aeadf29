// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/contact/standing_check.hpp"

#include <algorithm>

#include "estimator/imu/imu_filter_input.hpp"

namespace surefoot {

namespace {
// All values are chosen. Tests: test_off_ground.cpp, benchmarks/estimation (case hand). "Standing"
// below are logs of standing, pushed and stepping robots (go1, b1) without force sensors.
//
// [m/s] Speed of a foot relative to the base below which its leg is still. Equal to kRestSpeed of
// contact_confidence.cpp.
constexpr double kStillSpeed = 0.1;
// [s] Time constant of the low-pass of this speed. Ten samples against encoder noise.
constexpr double kFilterTime = 0.02;
// [s] Time in which turns count. If larger: a bias of the gyroscope counts as a turn.
constexpr double kTurnTime = 1.0;
// [rad] Turn that refutes. Chosen larger than the turn by a bias of 0.02 rad/s
// (start_gyroscope_bias). Logs of standing, pushed and stepping robots refute nothing.
constexpr double kMaxTurn = 0.1;
// [s] Time in which gained speed counts. If larger: errors of the tilt count as speed.
constexpr double kSpeedTime = 0.3;
// [rad/s] Larger rates count as this rate, so that a gyroscope that fails for 0.1 s does not
// refute.
constexpr double kMaxRate = 0.5;
// [m/s] Gained speed that refutes. Chosen. Logs of standing, pushed and stepping robots refute
// nothing.
constexpr double kMaxSpeed = 0.1;
// [s] Time constant of the low-pass of the gained speed: it removes the noise of the joint
// velocities.
constexpr double kSmoothTime = 0.05;
// [s] Time constant of the mean specific force, which contains gravity and bias and is not counted.
constexpr double kMeanTime = 2.0;
// Share of the limits below which a body is still. Chosen: above the turn by a bias of 0.02 rad/s.
constexpr double kStillShare = 0.25;
// [s] Time for which the body must be still before its legs are believed again. Longer than the
// turning point of a hand motion.
constexpr double kHoldTime = 1.0;

// Shorten a vector to `limit`, so that a large motion is not remembered for longer than a small
// one.
void limit_length(Vector3& vector, double limit) noexcept {
  vector *= limit / std::max(vector.norm(), limit);
}
}  // namespace

void StandingCheck::update(const Dynamics& dynamics, const StandingCheckInput& input,
                           double dt) noexcept {
  const bool was_refuted = refuted();
  refuted_time_ = std::max(refuted_time_ - dt, 0.0);
  turn_ *= 1.0 - dt / (dt + kTurnTime);
  speed_ *= 1.0 - dt / (dt + kSpeedTime);
  Vector3 w_base = input.w_base;
  limit_length(w_base, kMaxRate);
  FeetMatrix v = joint_velocities(dynamics, input.q, dt);
  Eigen::Vector4d legs = still_legs(v, dt);
  for (int leg = 0; leg < kLegs; ++leg) {
    if (!input.assumed[leg]) legs[leg] = 0.0;
    v.col(leg) += (dynamics.R_world_base() * w_base).cross(dynamics.legs()[leg].p_world_contact);
  }
  rotation_ = (rotation_ * exp_so3(dt * w_base)).normalized();
  const Matrix3 from_world = rotation_.toRotationMatrix() * dynamics.R_world_base().transpose();
  Vector3 rate;
  const bool compares = turn_of_feet(dynamics, legs, v, rate);
  if (compares) {
    turn_ += dt * from_world * rate;
    // With feet at rest, the IMU point moves as the legs say.
    const Vector3 v_legs =
        rotation_ * w_base.cross(input.arm) - from_world * (v * legs) / legs.sum();
    compare_speed(rotation_ * input.f_base, v_legs, dt);
    if (contradicted()) refuted_time_ = kHoldTime;
    limit_length(turn_, kMaxTurn);
    limit_length(speed_, 2.0 * kMaxSpeed);  // the low-pass must still exceed the limit
  }
  compared_ = compares;
  newly_refuted_ = refuted() && !was_refuted;
}

// Return the velocities of the contact points relative to the base, from the change of the joint
// angles: the noise of measured joint velocities would count as gained speed.
FeetMatrix StandingCheck::joint_velocities(const Dynamics& dynamics, const Vector12& q,
                                           double dt) noexcept {
  const Vector12 change = last_q_.hasNaN() ? Vector12::Zero() : Vector12(q - last_q_);
  last_q_ = q;
  FeetMatrix v;
  for (int leg = 0; leg < kLegs; ++leg)
    v.col(leg) = dynamics.legs()[leg].J_leg * change.segment<3>(3 * leg) / dt;
  return v;
}

// Return 1 for each leg that does not move relative to the base, 0 for the others.
Eigen::Vector4d StandingCheck::still_legs(const FeetMatrix& v, double dt) noexcept {
  v_joints_ += dt / (dt + kFilterTime) * (v - v_joints_);
  const Eigen::Vector4d speed = v_joints_.colwise().norm();
  return (speed.array() < kStillSpeed).cast<double>();
}

// Sum the speed that the body gains and that the legs do not explain. While the body turns far,
// errors of the gyroscope turn gravity too, so the mean begins again.
void StandingCheck::compare_speed(const Vector3& force, const Vector3& v_legs, double dt) noexcept {
  if (!has_mean_ || turn_.norm() > kMaxTurn) {
    mean_force_ = force;
    has_mean_ = true;
    speed_.setZero();
  } else if (compared_) {
    speed_ += dt * (force - mean_force_) - (v_legs - last_v_legs_);
    mean_force_ += dt / (dt + kMeanTime) * (force - mean_force_);
  }
  smooth_speed_ += dt / (dt + kSmoothTime) * (speed_ - smooth_speed_);
  last_v_legs_ = v_legs;
}

bool StandingCheck::contradicted() const noexcept {
  const double share = refuted() ? kStillShare : 1.0;
  return turn_.norm() > share * kMaxTurn || smooth_speed_.norm() > share * kMaxSpeed;
}

}  // namespace surefoot
