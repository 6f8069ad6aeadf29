// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <algorithm>

namespace surefoot {

/// Change of velocity that the body trajectory has begun: acceleration `a` for the next `time`
/// seconds, then none. Real-time: yes.
struct VelocityChange {
  Eigen::Vector2d a = Eigen::Vector2d::Zero();  ///< [m/s^2] world axes
  double time = 0.0;                            ///< [s] until the commanded velocity is reached

  /// Return by how much the velocity changes within t, from now on [m/s].
  Eigen::Vector2d velocity(double t) const noexcept { return std::min(t, time) * a; }

  /// Return the integral over 0 .. t of the distance by which the change moves the body [m s].
  Eigen::Vector2d position_integral(double t) const noexcept {
    const double now = std::min(t, time), then = t - now;
    return (now * now * now / 6.0 + 0.5 * now * then * (now + then)) * a;
  }
};

}  // namespace surefoot
