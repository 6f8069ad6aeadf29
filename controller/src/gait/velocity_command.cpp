// SPDX-License-Identifier: BSD-3-Clause
#include "gait/velocity_command.hpp"

#include <algorithm>
#include <cmath>

#include "gait/walk_power.hpp"

namespace surefoot {

namespace {

// Largest sum of the shares of the three limits in a trot. Measured: a go1 with random commands
// falls five times as seldom as without this limit. The combinations of walk_table.py are within
// it.
constexpr double kMaxTrotShares = 1.15;

// Return the factor, 0 .. 1, that brings a combined velocity within reach. In a trot a leg that
// moves sideways or turns has less travel left for the forward motion. A gait walk has one speed
// limit in every direction. In a curve the body accelerates by |v| |yaw rate|: at most by
// walk_acceleration, as along the path.
double combination_factor(const Gains& gains, bool walk, const WalkVelocity& velocity,
                          const WalkVelocity& limits) noexcept {
  const auto share = [](double value, double limit) {
    return value == 0.0 ? 0.0 : std::abs(value) / limit;
  };
  const Vector3 shares(share(velocity.vx, limits.vx), share(velocity.vy, limits.vy),
                       share(velocity.yaw_rate, limits.yaw_rate));
  const double together = walk ? shares.head<2>().norm() : shares.sum() / kMaxTrotShares;
  const double curve = std::hypot(velocity.vx, velocity.vy) * std::abs(velocity.yaw_rate) /
                       (gains.walk_acceleration * kGravity);
  return 1.0 / std::max({1.0, together, std::sqrt(curve)});
}

}  // namespace

void VelocityCommand::set(const Gains& gains, Gait gait, const WalkVelocity& velocity) noexcept {
  if (!std::isfinite(velocity.vx) || !std::isfinite(velocity.vy) ||
      !std::isfinite(velocity.yaw_rate)) {
    limit_ = WalkLimit::kNotFinite;
    return;
  }
  age_ = 0.0;
  requested_ = velocity;
  clamp(gains, gait);
}

void VelocityCommand::clamp(const Gains& gains, Gait gait) noexcept {
  const WalkVelocity& velocity = requested_;
  limit_ = WalkLimit::kNone;
  const auto clamped = [this](double value, double low, double high, WalkLimit limit) {
    if (value < low || value > high) limit_ = limit;
    return std::clamp(value, low, high);
  };
  const bool walk = gait == Gait::kWalk;
  const double sideways = (walk ? gains.walk_gait_speed : gains.walk_speed_sideways) * size_.speed;
  const double turn = (walk ? gains.walk_gait_turn_speed : gains.walk_turn_speed) / size_.time;
  velocity_.yaw_rate = clamped(velocity.yaw_rate, -turn, turn, WalkLimit::kTurn);
  velocity_.vy = clamped(velocity.vy, -sideways, sideways, WalkLimit::kSideways);
  const double forward = (walk ? gains.walk_gait_speed : gains.walk_speed_forward) * size_.speed;
  const double backward = (walk ? gains.walk_gait_speed : gains.walk_speed_backward) * size_.speed;
  velocity_.vx = clamped(velocity.vx, -backward, forward, WalkLimit::kForward);
  const WalkVelocity limits{velocity_.vx < 0.0 ? backward : forward, sideways, turn};
  scale(combination_factor(gains, walk, velocity_, limits), WalkLimit::kCombination);
  scale(power_factor(gains, size_, power_limit_, velocity_), WalkLimit::kPower);
}

void VelocityCommand::scale(double factor, WalkLimit limit) noexcept {
  if (factor == 1.0) return;
  limit_ = limit;
  velocity_ = {factor * velocity_.vx, factor * velocity_.vy, factor * velocity_.yaw_rate};
}

void VelocityCommand::advance(double dt) noexcept {
  age_ += dt;
  if (has_expired()) velocity_ = requested_ = {};
}

void VelocityCommand::reset() noexcept {
  age_ = std::numeric_limits<double>::infinity();
  velocity_ = requested_ = {};
  limit_ = WalkLimit::kNone;
}

bool VelocityCommand::is_zero() const noexcept {
  return velocity_.vx == 0.0 && velocity_.vy == 0.0 && velocity_.yaw_rate == 0.0;
}

}  // namespace surefoot
