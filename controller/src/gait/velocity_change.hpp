// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <algorithm>

namespace surefoot {

/// Remaining change of the planned velocity if the command stays constant: acceleration `a` for
/// `time_left`, then 0. The turn of the body is neglected. So is the rise of `a` when the yaw rate
/// reaches its command first. Real-time: yes.
struct VelocityChange {
  Eigen::Vector2d a = Eigen::Vector2d::Zero();  ///< [m/s^2] world axes
  double time_left = 0.0;                       ///< [s] until the commanded velocity is reached

  /// Return by how much the velocity will have changed at the time t from now [m/s].
  Eigen::Vector2d gained(double t) const noexcept { return std::min(t, time_left) * a; }

  /// Return the distance by which the change will have moved the body at the time t [m].
  Eigen::Vector2d moved(double t) const noexcept {
    const double changing = std::min(t, time_left), after = t - changing;
    return (0.5 * changing + after) * changing * a;
  }

  /// Return the integral of moved() over 0 .. t [m s].
  Eigen::Vector2d moved_integral(double t) const noexcept {
    const double changing = std::min(t, time_left), after = t - changing;
    return (changing * changing / 6.0 + 0.5 * after * (changing + after)) * changing * a;
  }
};

}  // namespace surefoot
