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
// [rad] Turn that refutes. Larger than 0.007, the largest value of standing, and than the turn by
// a bias of 0.02 rad/s (start_gyroscope_bias).
constexpr double kMaxTurn = 0.1;
// [s] Time in which gained speed counts. If larger: errors of the tilt count as speed.
constexpr double kSpeedTime = 0.3;
// [m/s] Gained speed that refutes. Larger than 0.06, the largest value of standing.
constexpr double kMaxSpeed = 0.1;
// [s] Time constant of the low-pass of the gained speed: it removes the noise of the joint
// velocities.
constexpr double kSmoothTime = 0.05;
// [s] Time constant of the mean acceleration, which is not counted: tilt error and bias look like a
// constant acceleration.
constexpr double kMeanTime = 2.0;
// [rad] Standard deviation of the tilt up to which gained speed counts. Larger than 0.0144, the
// tilt by a bias of start_accelerometer_bias on two axes.
constexpr double kMaxTiltSigma = 0.02;
// Share of the limits below which a body is still. Chosen: above the values of standing at rest
// (0.006 rad, 0.009 m/s) and the turn by a bias of 0.02 rad/s.
constexpr double kStillShare = 0.25;
// [s] Time for which the body must be still before its legs are believed again. Longer than the
// turning point of a hand motion.
constexpr double kHoldTime = 1.0;
}  // namespace

void StandingCheck::update(const Dynamics& dynamics, const StandingCheckInput& input,
                           double dt) noexcept {
  const bool was_refuted = refuted();
  refuted_time_ = std::max(refuted_time_ - dt, 0.0);
  turn_ *= 1.0 - dt / (dt + kTurnTime);
  speed_ *= 1.0 - dt / (dt + kSpeedTime);
  Eigen::Vector4d legs = still_legs(dynamics, dt);
  FeetMatrix v;
  for (int leg = 0; leg < kLegs; ++leg) {
    if (!input.assumed[leg]) legs[leg] = 0.0;
    v.col(leg) = dynamics.legs()[leg].v_world_contact;
  }
  Vector3 rate;
  const bool compares = turn_of_feet(dynamics, legs, v, rate);
  if (compares) {
    turn_ += dt * rate;
    // With feet at rest, the IMU point moves as the legs say.
    const Vector3 v_legs = dynamics.w_world_base().cross(input.arm) - v * legs / legs.sum();
    if (compared_) compare_speed(dt * input.acceleration - (v_legs - last_v_legs_), dt);
    last_v_legs_ = v_legs;
    if (contradicted(input.tilt_sigma)) refuted_time_ = kHoldTime;
  }
  compared_ = compares;
  newly_refuted_ = refuted() && !was_refuted;
}

// Return 1 for each leg that does not move relative to the base, 0 for the others.
Eigen::Vector4d StandingCheck::still_legs(const Dynamics& dynamics, double dt) noexcept {
  Eigen::Vector4d still;
  for (int leg = 0; leg < kLegs; ++leg) {
    const LegDynamics& L = dynamics.legs()[leg];
    const Vector3 v = L.v_world_contact - dynamics.w_world_base().cross(L.p_world_contact);
    v_joints_.col(leg) += dt / (dt + kFilterTime) * (v - v_joints_.col(leg));
    still[leg] = v_joints_.col(leg).norm() < kStillSpeed ? 1.0 : 0.0;
  }
  return still;
}

// `gain` is the speed that the body gained in this tick and that the legs do not explain.
void StandingCheck::compare_speed(const Vector3& gain, double dt) noexcept {
  const Vector3 change = gain - dt * mean_acceleration_;
  speed_ += change;
  smooth_speed_ += dt / (dt + kSmoothTime) * (speed_ - smooth_speed_);
  mean_acceleration_ += change / (dt + kMeanTime);
}

bool StandingCheck::contradicted(double tilt_sigma) const noexcept {
  const double share = refuted() ? kStillShare : 1.0;
  return turn_.norm() > share * kMaxTurn ||
         (tilt_sigma < kMaxTiltSigma && smooth_speed_.norm() > share * kMaxSpeed);
}

}  // namespace surefoot
