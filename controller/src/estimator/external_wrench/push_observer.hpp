// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/gains.hpp"
#include "surefoot/math.hpp"

namespace surefoot {

/// Sees an outside force on the body by what the accelerometer feels and the commands do not
/// explain, F = m (a_measured - a_feet), where the feet make a_planned less what the plan counted
/// with of F itself; smoothed, with a dead band that keeps noise and small
/// errors of the model out, and bounded. The more it surprises along the ground, the sooner it is
/// believed, for a twentieth of a second, by a robot on its feet: what a push gains in its first 10
/// ms decides whether it is survived. Real-time: update() yes.
///
/// Without it a push is felt only once it has moved the body, and the legs of unloaded feet, whose
/// motion is planned for a body at rest, are dragged along.
class PushObserver {
 public:
  /// @param unexplained acceleration of the base, measured less what the feet were to make of it,
  /// world axes [m/s^2]
  /// @param supported do the feet bear the robot?
  void update(const Gains& gains, const Vector3& unexplained, bool supported, double dt) noexcept;

  /// Outside acceleration that is believed, world axes [m/s^2].
  Vector3 acceleration(const Gains& gains) const noexcept;

  void reset() noexcept { *this = PushObserver(); }

 private:
  double time_scale(const Gains& gains, double innovation_norm, bool supported, double dt) noexcept;

  Vector3 filtered_ = Vector3::Zero();
  double innovation_time_ = 0.0;  // [s] of late
};

}  // namespace surefoot
