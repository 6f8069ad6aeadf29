// SPDX-License-Identifier: BSD-3-Clause
#include "tick/first_samples.hpp"

#include <algorithm>
#include <cmath>

#include "dynamics/dynamics.hpp"
#include "low_level/low_state_check.hpp"
#include "reference/capture_margin.hpp"

namespace surefoot {

namespace {

// [s] Time for which the sensor that was implausible in the first sample must be so. Chosen. Longer
// than one sample; not longer than the 6 ms in which tauEst falls once the motors brake.
constexpr double kImplausibleTime = 0.004;
// [s] Time after which joint angles are judged. Chosen. Longer than one wrong sample; shorter than
// 0.05 s, in which a robot that falls freely drops by 1 cm.
constexpr double kJointTime = 0.02;
// [rad] Distance outside its range from which an angle cannot be that of its joint. Equal to
// kSwapMargin in arming_joint_checks.cpp.
constexpr double kRangeMargin = 0.2;
// [s] Time constant of the filter on the accelerometer. Chosen. Longer than the noise, shorter than
// kTime.
constexpr double kFilterTime = 0.02;
// [g] Range of the specific force of a robot that stands. Equal to the range in which `surefoot
// estimate` has no doubt (estimate/checks/imu.py).
constexpr double kMinForce = 0.7, kMaxForce = 1.4;
// [rad] 20 degrees: angle between the verticals of accelerometer and quaternion from which one of
// them is wrong. Equal to WRONG_TILT in estimate/checks/quaternion.py.
constexpr double kMaxTiltDifference = 0.35;

// Cosine of the tilt below which the support is judged: 25 degrees, kMaxTilt in arming_checks.cpp.
constexpr double kMinUpright = 0.906;

double angle_to(const Vector3& a, const Vector3& unit) noexcept {
  return std::acos(std::clamp(a.dot(unit) / std::max(a.norm(), 1e-9), -1.0, 1.0));
}

// Return the unit normal of the plane through the feet, base axes: from the diagonals.
Vector3 support_normal(const Dynamics& dynamics) noexcept {
  const auto& legs = dynamics.legs();
  const Vector3 normal = (legs[0].p_world_contact - legs[3].p_world_contact)
                             .cross(legs[1].p_world_contact - legs[2].p_world_contact);
  return dynamics.R_world_base().transpose() * normal.normalized();
}

}  // namespace

void FirstSamples::reset() noexcept {
  time_ = 0.0;
  implausible_ = Status::kOk;
  implausible_time_ = 0.0;
  joints_out_of_range_ = unsupported_ = no_gravity_ = contradicts_attitude_ = true;
}

Status FirstSamples::update(const LowState& low_state, Status estimated,
                            const StateEstimator& estimator, double dt) noexcept {
  const bool first = time_ == 0.0;
  time_ += dt;
  const Status beyond =
      estimated == Status::kImplausible ? implausible_sensor(low_state, config_) : Status::kOk;
  if (first) implausible_ = beyond;
  if (beyond == implausible_) implausible_time_ += dt;
  if (estimated == Status::kOk) {
    if (first) acceleration_.setZero();
    judge_accelerometer(low_state.imu, estimator.dynamics(), first ? kTime : dt);
    judge_joints(low_state, estimator.dynamics());
  } else {
    joints_out_of_range_ = unsupported_ = no_gravity_ = contradicts_attitude_ = false;
  }
  if (implausible_ != Status::kOk && implausible_time_ >= kImplausibleTime) return implausible_;
  if (time_ >= kJointTime && (joints_out_of_range_ || unsupported_)) {
    return Status::kWrongJointAngles;
  }
  if (!done()) return Status::kOk;
  const SensorVerdict verdict = estimator.report().accelerometer;
  const bool stuck = verdict == SensorVerdict::kZero || verdict == SensorVerdict::kConstant;
  return no_gravity_ || contradicts_attitude_ || stuck ? Status::kWrongAccelerometer : Status::kOk;
}

// The centre of mass of a robot that stands is above its feet.
void FirstSamples::judge_joints(const LowState& low_state, const Dynamics& dynamics) noexcept {
  double outside = 0.0;
  for (int i = 0; i < kMotors; ++i) {
    const double q = low_state.motorState[i].q;
    outside = std::max({outside, q - config_.q_upper[i], config_.q_lower[i] - q});
  }
  joints_out_of_range_ &= outside > kRangeMargin;
  const bool upright = !contradicts_attitude_ && dynamics.R_world_base()(2, 2) > kMinUpright;
  unsupported_ &= upright && capture_margin(dynamics, {true, true, true, true}) < 0.0;
}

// A robot that stands measures gravity, along the vertical of its quaternion. The plane of the feet
// decides whether accelerometer or quaternion is wrong.
void FirstSamples::judge_accelerometer(const IMU& imu, const Dynamics& dynamics,
                                       double dt) noexcept {
  const std::array<float, 3> a = imu.accelerometer;  // packed: not aligned
  const std::array<float, 4> q = imu.quaternion;
  const double blend = -std::expm1(-dt / kFilterTime);
  acceleration_ += blend * (Vector3(a[0], a[1], a[2]) - acceleration_);
  const double force = acceleration_.norm() / kGravity;
  no_gravity_ &= !(force > kMinForce && force < kMaxForce);
  const Quaternion R_world_imu(q[0], q[1], q[2], q[3]);
  const Vector3 up = R_world_imu.normalized().conjugate() * Vector3::UnitZ();
  const Vector3 normal =
      quaternion_wxyz(config_.quat_base_imu).conjugate() * support_normal(dynamics);
  contradicts_attitude_ &= has_unit_quaternion(imu) &&
                           angle_to(acceleration_, up) > kMaxTiltDifference &&
                           angle_to(acceleration_, normal) > angle_to(up, normal);
}

}  // namespace surefoot
