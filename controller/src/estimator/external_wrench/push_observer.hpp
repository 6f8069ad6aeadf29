// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/gains.hpp"
#include "surefoot/math.hpp"

namespace surefoot {

/// Observer of a push: of the external force F = m (a_measured - a_feet) on the body.
///
/// a_feet is the acceleration that the planned contact forces cause: a_planned - F_planned / m,
/// where F_planned is the push that the planned motion includes. The difference passes a
/// first-order low-pass, a dead band against noise and small model errors, and a bound. While the
/// feet carry the robot, large horizontal innovations (the difference minus its low-pass) shorten
/// the time constant for at most 50 ms, because the first 10 ms of a push decide whether the robot
/// survives it. Real-time: yes.
///
/// Without this observer the controller would react only after a push has moved the body. Also, the
/// QP would plan the motion of unloaded legs for a body that is not pushed, and these legs would
/// lag behind the pushed body.
class PushObserver {
 public:
  /// Process one tick.
  /// @param unexplained a_measured - a_feet of the base origin, world axes [m/s^2]
  /// @param supported true if the feet carry the robot
  void update(const Gains& gains, const Vector3& unexplained, bool supported, double dt) noexcept;

  /// Compute the acceleration of the body that the push causes, after dead band and bound [m/s^2],
  /// world axes.
  Vector3 acceleration(const Gains& gains) const noexcept;

  void reset() noexcept { *this = PushObserver(); }

 private:
  double time_scale(const Gains& gains, double innovation_norm, bool supported, double dt) noexcept;

  Vector3 filtered_ = Vector3::Zero();  // [m/s^2] low-pass of `unexplained`
  // [s] Total time of large innovations; falls slowly while they are small.
  double innovation_time_ = 0.0;
};

}  // namespace surefoot
