// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/external_wrench/push_observer.hpp"

#include <algorithm>

namespace surefoot {

namespace {
// kNoiseLevel, kHalvingLevel and kMinTimeScale are chosen with pushes from 16 directions (git
// a0e3774): with these values a go1 survived 100 % of its push limit, without them 97.5 %.
//
// An innovation below this value is noise or a model error. In units of the gain push_dead_band:
// 1.5 m/s^2 by default.
constexpr double kNoiseLevel = 3.0;
// Excess of the innovation over kNoiseLevel at which the time constant is halved. In units of
// push_dead_band.
constexpr double kHalvingLevel = 1.0;
// Shortest time constant, in units of push_time: 6 ms by default. Measured: at 4 ms the torques of
// a b1 exceeded the supervisor's limit of the torque rate (git e0f1814). With 1, the time constant
// would never be shortened. With 6 ms at 500 Hz, one wrong sample moves the estimate by a quarter
// of the error of the sample.
constexpr double kMinTimeScale = 3.0 / 8.0;
// [s] Longest total time of large innovations (above kNoiseLevel) in which the time constant is
// shortened. Long enough for the start and the end of a push. Measured: without this bound, a body
// with an unknown delay of 16 ms swayed for ever (git ff9d8bc).
constexpr double kMaxInnovationTime = 0.05;
// [s/s] Rate at which the counted time falls while innovations are small. Derived:
// kMaxInnovationTime in 1 s.
constexpr double kInnovationTimeDecay = 0.05;
}  // namespace

// Only horizontal innovations shorten the time constant, because only horizontal pushes can topple
// the robot. Large vertical innovations come from accelerometer dropouts and landing feet.
void PushObserver::update(const Gains& gains, const Vector3& unexplained, bool supported,
                          double dt) noexcept {
  const Vector3 innovation = unexplained - filtered_;
  const double time_constant =
      gains.push_time * time_scale(gains, innovation.head<2>().norm(), supported, dt);
  filtered_.head<2>() += dt / (dt + time_constant) * innovation.head<2>();
  filtered_.z() += dt / (dt + gains.push_time) * innovation.z();
}

// Compute the time constant as a share of push_time. If the actual delay of the robot exceeds
// ControllerOptions::delay, the body can sway, and the innovations stay large. A shortened time
// constant would sustain this oscillation. So the time constant is shortened for at most
// kMaxInnovationTime. While the robot is lifted, the time constant is not shortened at all, because
// the feet cannot exert the planned forces.
double PushObserver::time_scale(const Gains& gains, double innovation_norm, bool supported,
                                double dt) noexcept {
  const double excess = innovation_norm - kNoiseLevel * gains.push_dead_band;
  innovation_time_ = std::clamp(innovation_time_ + (excess > 0.0 ? dt : -kInnovationTimeDecay * dt),
                                0.0, kMaxInnovationTime);
  if (excess <= 0.0 || innovation_time_ >= kMaxInnovationTime || !supported) return 1.0;
  const double half_level = kHalvingLevel * gains.push_dead_band;
  return std::max(half_level / (half_level + excess), kMinTimeScale);
}

Vector3 PushObserver::acceleration(const Gains& gains) const noexcept {
  const double norm = filtered_.norm();
  const double magnitude = std::clamp(norm - gains.push_dead_band, 0.0, gains.push_max);
  return norm > 0.0 ? Vector3(magnitude / norm * filtered_) : Vector3::Zero();
}

}  // namespace surefoot
