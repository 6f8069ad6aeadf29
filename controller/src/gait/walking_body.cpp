// SPDX-License-Identifier: BSD-3-Clause
#include "gait/walking_body.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace surefoot {

namespace {

constexpr double kMaxAcceleration = 2.0;      // [m/s^2] chosen: 1 m/s within half a second
constexpr double kMaxTurnAcceleration = 8.0;  // [rad/s^2] chosen
// [m], [rad] Largest distance of the reference from the measured body. Chosen: beyond, a push would
// make the body rush back to where it would have been.
constexpr double kMaxDistance = 0.05;
constexpr double kMaxTurn = 0.1;

double approached(double value, double target, double step) noexcept {
  return value + std::clamp(target - value, -step, step);
}

double wrapped(double angle) noexcept { return std::remainder(angle, 2.0 * M_PI); }

}  // namespace

void WalkingBody::start(const Vector3& p_com, double yaw) noexcept {
  *this = {};
  p_ = p_com;
  yaw_ = yaw;
}

void WalkingBody::update(const VelocityCommand& command, double height, double ground,
                         const Vector3& p_com, double yaw, double dt) noexcept {
  const Eigen::Vector2d last(velocity_.vx, velocity_.vy);
  const Eigen::Vector2d change = Eigen::Vector2d(command.vx, command.vy) - last;
  const double step = kMaxAcceleration * dt;
  const Eigen::Vector2d next = last + std::min(1.0, step / std::max(change.norm(), 1e-9)) * change;
  velocity_ = {next.x(), next.y(),
               approached(velocity_.yaw_rate, command.yaw_rate, kMaxTurnAcceleration * dt)};
  yaw_ += dt * velocity_.yaw_rate;
  yaw_ = yaw + std::clamp(wrapped(yaw_ - yaw), -kMaxTurn, kMaxTurn);
  const Eigen::Rotation2Dd R(yaw_);
  v_.head<2>() = R * next;
  a_.head<2>() = R * Eigen::Vector2d((next - last) / dt) +
                 velocity_.yaw_rate * Eigen::Vector2d(-v_.y(), v_.x());
  p_.head<2>() += dt * v_.head<2>();
  const Eigen::Vector2d away = (p_ - p_com).head<2>();
  p_.head<2>() =
      p_com.head<2>() + std::min(1.0, kMaxDistance / std::max(away.norm(), 1e-9)) * away;
  p_.z() = ground + height;
}

void WalkingBody::write(Reference& reference) const noexcept {
  reference.body_point = BodyPoint::kCenterOfMass;
  reference.p_com = p_;
  reference.v_com = v_;
  reference.a_com = a_;
  reference.R_world_base = exp_so3(yaw_ * Vector3::UnitZ());
  reference.w_world_base = velocity_.yaw_rate * Vector3::UnitZ();
  reference.alpha_world_base.setZero();
}

}  // namespace surefoot
