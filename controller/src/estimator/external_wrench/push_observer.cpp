// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/external_wrench/push_observer.hpp"

#include <algorithm>

namespace surefoot {

namespace {
constexpr double kNoiseLevel =
    3.0;  // [push_dead_band] that surprise slowly: noise, errors of the model
constexpr double kFastLevel = 1.0;  // [push_dead_band] more than that: believed in half the time
constexpr double kMinTimeScale =
    3.0 / 8.0;  // [push_time]: no single wrong sample is believed whole
constexpr double kMaxInnovationTime =
    0.05;  // [s] of surprise that are believed sooner: a push's two ends
constexpr double kInnovationTimeDecay = 0.05;  // [s] of them forgotten in every second without
}  // namespace

// Pushes that a stand may not survive are horizontal. Vertical surprises are accelerometers that
// drop out, and feet that land.
void PushObserver::update(const Gains& gains, const Vector3& unexplained, bool supported,
                          double dt) noexcept {
  const Vector3 innovation = unexplained - filtered_;
  const double time =
      gains.push_time * time_scale(gains, innovation.head<2>().norm(), supported, dt);
  filtered_.head<2>() += dt / (dt + time) * innovation.head<2>();
  filtered_.z() += dt / (dt + gains.push_time) * innovation.z();
}

// What surprises on and on is the body's own sway, at more delay than was told of: believed that
// soon, it would go on for good. So would legs that hang from a hand, which bear nothing of a plan
// that counts on feet.
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
  const double believed = std::clamp(size - gains.push_dead_band, 0.0, gains.push_max);
  return size > 0.0 ? Vector3(believed / size * filtered_) : Vector3::Zero();
}

}  // namespace surefoot
