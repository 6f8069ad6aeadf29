// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/gains.hpp"
#include "surefoot/math.hpp"

namespace surefoot {

/// Observer of a push: external force F = m (a_measured - a_feet) on the body.
///
/// a_feet is the acceleration that the contact forces were planned to cause: a_planned less the
/// push that the plan took into account. The difference passes a first-order low-pass, a dead band
/// against noise and small model errors, and a bound. While the feet carry the robot, large
/// horizontal innovations shorten the time constant, for 50 ms at most: the first 10 ms of a push
/// decide whether it is survived. Real-time: update() yes.
///
/// Without this observer the controller reacts only after a push has moved the body. The legs of
/// unloaded feet, whose motion is planned for a body at rest, would be dragged along.
class PushObserver {
 public:
  /// Process one tick.
  /// @param unexplained a_measured - a_feet of the base origin, world axes [m/s^2]
  /// @param supported true if the feet carry the robot
  void update(const Gains& gains, const Vector3& unexplained, bool supported, double dt) noexcept;

  /// Compute the acceleration by the push, after dead band and bound, world axes [m/s^2].
  Vector3 acceleration(const Gains& gains) const noexcept;

  void reset() noexcept { *this = PushObserver(); }

 private:
  double time_scale(const Gains& gains, double innovation_norm, bool supported, double dt) noexcept;

  Vector3 filtered_ = Vector3::Zero();
  double innovation_time_ = 0.0;  // [s] of large innovations, leaky
};

}  // namespace surefoot
