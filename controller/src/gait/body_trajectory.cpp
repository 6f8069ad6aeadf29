// SPDX-License-Identifier: BSD-3-Clause
#include "gait/body_trajectory.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace surefoot {

namespace {

// Largest distance of the trajectory from the measured body. Chosen larger than the tracking error
// of a walk that is not pushed. If larger: after a push the robot rushes back.
constexpr double kMaxDistance = 0.17;  // [h]
constexpr double kMaxTurn = 0.1;       // [rad]
// [s] Time constant with which the body approaches the standing height. Chosen: a period of the
// stepping that begins.
constexpr double kHeightTime = 0.2;

double approached(double value, double target, double step) noexcept {
  return value + std::clamp(target - value, -step, step);
}

}  // namespace

void BodyTrajectory::start(const HorizontalMotion& measured, double height) noexcept {
  velocity_ = {};
  p_ = measured.p_com;
  v_.setZero();
  a_.setZero();
  change_ = {};
  yaw_ = measured.yaw;
  height_ = height;
}

void BodyTrajectory::update(const Gains& gains, const WalkVelocity& command,
                            const HorizontalMotion& measured, double acceleration_share,
                            double dt) noexcept {
  update_velocity(gains, command, acceleration_share, dt);
  p_ += dt * v_;
  const Eigen::Vector2d ahead = p_ - measured.p_com;
  const double limit = kMaxDistance * size_.height;
  p_ = measured.p_com + std::min(1.0, limit / std::max(ahead.norm(), 1e-9)) * ahead;
  yaw_ += dt * velocity_.yaw_rate;
  const double turned = std::remainder(yaw_ - measured.yaw, 2.0 * M_PI);
  yaw_ = measured.yaw + std::clamp(turned, -kMaxTurn, kMaxTurn);
  height_ += dt / (dt + kHeightTime) * (size_.height - height_);
}

void BodyTrajectory::update_velocity(const Gains& gains, const WalkVelocity& command,
                                     double acceleration_share, double dt) noexcept {
  const Eigen::Vector2d last(velocity_.vx, velocity_.vy);
  const Eigen::Vector2d change = Eigen::Vector2d(command.vx, command.vy) - last;
  double step = acceleration_share * gains.walk_acceleration * kGravity * dt;
  double turn_step =
      acceleration_share * gains.walk_turn_acceleration * kGravity / size_.height * dt;
  // Both accelerations move the hips away from the stance feet, so the shares of the limits add.
  const double turn_change = std::abs(command.yaw_rate - velocity_.yaw_rate);
  const double shares =
      std::min(1.0, change.norm() / std::max(step, 1e-12)) +
      std::min(1.0, turn_change / std::max(turn_step, 1e-12));  // no division by zero
  step /= std::max(1.0, shares);
  turn_step /= std::max(1.0, shares);
  const Eigen::Vector2d next = last + std::min(1.0, step / std::max(change.norm(), 1e-9)) * change;
  velocity_ = {next.x(), next.y(), approached(velocity_.yaw_rate, command.yaw_rate, turn_step)};
  const Eigen::Rotation2Dd R(yaw_);
  v_ = R * next;
  const double rest = (change - (next - last)).norm();
  change_ = {R * ((next - last) / dt), rest / std::max(step, 1e-12) * dt};
  a_ = change_.a + velocity_.yaw_rate * Eigen::Vector2d(-v_.y(), v_.x());
}

void BodyTrajectory::write(const GroundPlane& ground, const BodySway& sway,
                           const BodyMotion& offset, double ahead,
                           Reference& reference) const noexcept {
  const Eigen::Vector2d a = a_ + sway.a(), v_now = v_ + sway.v(), v = v_now + ahead * a;
  const Eigen::Vector2d p = p_ + sway.p() + ahead * v_now;
  const Vector3& n = ground.normal();
  const Eigen::Vector2d slope = -n.head<2>() / n.z();  // rise per distance
  reference.body_point = BodyPoint::kCenterOfMass;
  reference.p_com << p, ground.height_of_soles(p) + height_ + offset.relative_pose().height;
  reference.v_com << v, slope.dot(v) + offset.v_height();
  reference.a_com << a, slope.dot(a);
  const Quaternion heading = exp_so3((yaw_ + ahead * velocity_.yaw_rate) * Vector3::UnitZ());
  const Quaternion R = Quaternion::FromTwoVectors(Vector3::UnitZ(), n) * heading;
  reference.R_world_base = R * offset.R_base();
  reference.w_world_base = velocity_.yaw_rate * n + R * offset.w_base();
  reference.alpha_world_base = R * offset.alpha_base();
  reference.use_forces = false;
  reference.ground_normal = n;
}

}  // namespace surefoot
