// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/external_wrench/push_observer.hpp"

#include <algorithm>

namespace surefoot {

namespace {
// [push_dead_band] Innovations up to this level (1.5 m/s^2 by default) are noise and model errors.
// Chosen, with the next two, by pushes from 16 directions (git a0e3774): go1 97.5 -> 100 % of its
// limit.
constexpr double kNoiseLevel = 3.0;
constexpr double kFastLevel = 1.0;  // [push_dead_band] excess that halves the time constant
// [push_time] Shortest time constant, 6 ms by default. Measured: at 4 ms the torques of a b1
// exceeded the supervisor's rate (git e0f1814); above 1 it has no effect. One wrong sample counts
// by a quarter.
constexpr double kMinTimeScale = 3.0 / 8.0;
// [s] Longest time of large innovations with a shorter time constant: both ends of a push.
// Measured: without a bound, a body with 16 ms of unknown delay swayed for ever (git ff9d8bc).
constexpr double kMaxInnovationTime = 0.05;
// [s/s] Recovery of that time afterwards. Derived: kMaxInnovationTime in 1 s.
constexpr double kInnovationTimeDecay = 0.05;
}  // namespace

// Only horizontal innovations shorten the time constant, because only horizontal pushes can topple
// the robot. Large vertical innovations come from accelerometer dropouts and from landing feet.
void PushObserver::update(const Gains& gains, const Vector3& unexplained, bool supported,
                          double dt) noexcept {
  const Vector3 innovation = unexplained - filtered_;
  const double time =
      gains.push_time * time_scale(gains, innovation.head<2>().norm(), supported, dt);
  filtered_.head<2>() += dt / (dt + time) * innovation.head<2>();
  filtered_.z() += dt / (dt + gains.push_time) * innovation.z();
}

// Compute the time constant as a share of push_time. Persistent large innovations are the body's
// own sway, when the actual delay exceeds the configured one; a short time constant would sustain
// that oscillation. The same holds for a lifted robot, whose feet cannot exert the planned forces.
double PushObserver::time_scale(const Gains& gains, double innovation_norm, bool supported,
                                double dt) noexcept {
  const double excess = innovation_norm - kNoiseLevel * gains.push_dead_band;
  innovation_time_ = std::clamp(innovation_time_ + (excess > 0.0 ? dt : -kInnovationTimeDecay * dt),
                                0.0, kMaxInnovationTime);
  if (excess <= 0.0 || innovation_time_ >= kMaxInnovationTime || !supported) return 1.0;
  const double half_level = kFastLevel * gains.push_dead_band;
  return std::max(half_level / (half_level + excess), kMinTimeScale);
}

Vector3 PushObserver::acceleration(const Gains& gains) const noexcept {
  const double size = filtered_.norm();
  const double magnitude = std::clamp(size - gains.push_dead_band, 0.0, gains.push_max);
  return size > 0.0 ? Vector3(magnitude / size * filtered_) : Vector3::Zero();
}

}  // namespace surefoot
