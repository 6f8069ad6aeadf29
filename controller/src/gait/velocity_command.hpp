// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>

#include "gait/gait_size.hpp"
#include "surefoot/gains.hpp"
#include "surefoot/walk_velocity.hpp"

namespace surefoot {

/// Commanded velocity: clamped to what the gains allow, and 0 when it is too old. Real-time: yes.
class VelocityCommand {
 public:
  /// @param timeout age above which the command becomes 0 [s]
  /// @param power_limit [m g sqrt(g h)], see power_factor()
  VelocityCommand(const GaitSize& size, double timeout, double power_limit)
      : size_(size), timeout_(timeout), power_limit_(power_limit) {}

  /// Set the velocity, clamped to the limits of the gait: first each component; then all three are
  /// scaled by one factor, which keeps the curvature of the path. A velocity with a NaN or an
  /// infinity changes nothing.
  void set(const Gains& gains, Gait gait, const WalkVelocity& velocity) noexcept;
  /// Clamp the velocity of the last set() again, for another gait.
  void clamp(const Gains& gains, Gait gait) noexcept;
  void advance(double dt) noexcept;
  void reset() noexcept;

  const WalkVelocity& velocity() const noexcept { return velocity_; }
  bool is_zero() const noexcept;
  /// Return whether the last set() is older than the timeout, or nothing was set since reset().
  bool has_expired() const noexcept { return age_ > timeout_; }
  WalkLimit limit() const noexcept { return limit_; }  ///< of the last set() or clamp()

 private:
  void scale(double factor, WalkLimit limit) noexcept;

  GaitSize size_;
  double timeout_;
  double power_limit_;
  double age_ = std::numeric_limits<double>::infinity();  // [s]
  WalkVelocity requested_, velocity_;
  WalkLimit limit_ = WalkLimit::kNone;
};

}  // namespace surefoot
