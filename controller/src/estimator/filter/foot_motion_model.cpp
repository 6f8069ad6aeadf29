// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/filter/foot_motion_model.hpp"

#include <algorithm>
#include <cmath>

namespace surefoot {

namespace {
// [s] Time constant of the low-pass against encoder noise. Chosen longer than a few samples at
// 500 Hz, and shorter than kSwingTime.
constexpr double kFilterTime = 0.01;
// [s] Sample period for which the noise gains are given. Convention: 500 Hz.
constexpr double kNoisePeriod = 0.002;
// Assumed speed of a foot off the ground: kSwingSpeed [m/s] plus kSwingShare times the foot's speed
// relative to the base. It is assumed to last for kSwingTime [s]. Chosen so large that the filter
// gives such a foot no weight; the assumed speed of a stance foot is 0.0005 m/s (noise_foot_slip).
constexpr double kSwingSpeed = 3.0;
constexpr double kSwingShare = 3.0;
constexpr double kSwingTime = 0.1;
// Load, as a share of the weight, at which the assumed slip speed has fallen from kUnloadedSpeed by
// a factor of e = 2.7. Chosen: half of contact_force_off (0.06), at which contact ends; at rest a
// foot carries 0.25.
constexpr double kUnloadedShare = 0.03;
constexpr double kUnloadedSpeed = 0.5;  // [m/s] assumed slip speed of a foot without load
// [m/s] Assumed slip speed of the stance feet of a robot that steps, instead of noise_foot_slip.
// Chosen: soles creep and twist while their load changes. With the default of
// noise_foot_slip the feet outweigh the gyroscope: the yaw of laps of 40 s is wrong by 0.6 deg
// instead of 0.4. Half of the value changes little.
constexpr double kSteppingSlip = 0.01;
// [s] Time for which a contact point that moves faster than the gain slip_speed is assumed to keep
// its velocity. Chosen: soles of a trotting Go1 slide for 20 to 35 ms after touchdown and before
// lift-off.
constexpr double kSlidingTime = 0.03;
// [m/s] Assumed slip speed of a foot whose force is at the learnt limit of friction. Such a foot
// may slide, and below slip_speed nothing else shows it. Chosen: above slip_speed, so that the IMU
// alone gives the velocity of a robot whose feet are all at the limit.
constexpr double kLimitSpeed = 0.5;
}  // namespace

void FootMotionModel::update_velocity(const Dynamics& dynamics, double dt) noexcept {
  for (int leg = 0; leg < kLegs; ++leg) {
    v_.col(leg) += dt / (dt + kFilterTime) * (dynamics.legs()[leg].v_world_contact - v_.col(leg));
  }
}

FeetMatrix FootMotionModel::rolling_displacement(const Dynamics& dynamics, const Vector12& q,
                                                 const Eigen::Vector4d& contact,
                                                 const FeetMatrix& lever, double dt) noexcept {
  const Vector12 joint_change = q - last_q_;
  last_q_ = q;
  if (!has_last_q_) {
    has_last_q_ = true;
    return FeetMatrix::Zero();
  }
  const Vector3 base_rotation = dt * dynamics.w_world_base();
  FeetMatrix displacement;
  for (int leg = 0; leg < kLegs; ++leg) {
    const Vector3 turn =
        base_rotation + dynamics.legs()[leg].joint_axes_world * joint_change.segment<3>(3 * leg);
    displacement.col(leg) = contact[leg] * turn.cross(lever.col(leg));
  }
  return displacement;
}

Eigen::Vector4d FootMotionModel::process_variance(const Gains& gains, const FootContactState& feet,
                                                  double dt) const noexcept {
  Eigen::Vector4d out;
  for (int leg = 0; leg < kLegs; ++leg) {
    const double off_ground = feet.rejected[leg] ? 1.0 : 1.0 - feet.contact[leg];
    const double unloaded = std::exp(-std::max(feet.load[leg], 0.0) / kUnloadedShare);
    const double speed = v_.col(leg).norm();
    const double slip_speed = (feet.steps ? kSteppingSlip : gains.noise_foot_slip) +
                              gains.noise_foot_motion * speed + unloaded * kUnloadedSpeed;
    const double sliding_speed = std::max(feet.speed[leg] - gains.slip_speed, 0.0);
    const double limit_speed = kLimitSpeed * feet.at_friction_limit[leg];
    const double swing_speed = off_ground * off_ground * (kSwingSpeed + kSwingShare * speed);
    out[leg] = dt * (slip_speed * slip_speed * kNoisePeriod +
                     (sliding_speed * sliding_speed + limit_speed * limit_speed) * kSlidingTime +
                     swing_speed * swing_speed * kSwingTime);
  }
  return out;
}

}  // namespace surefoot
