// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/outside/push_observer.hpp"

#include <algorithm>

namespace surefoot {

namespace {
constexpr double kNoise = 3.0;  // [push_dead_band] that surprise slowly: noise, errors of the model
constexpr double kSooner = 1.0;  // [push_dead_band] more than that: believed in half the time
constexpr double kSoonest = 3.0 / 8.0;  // [push_time]: no single wrong sample is believed whole
constexpr double kAlert = 0.05;   // [s] of surprise that are believed sooner: a push's two ends
constexpr double kForget = 0.05;  // [s] of them forgotten in every second without
}  // namespace

// Pushes that a stand may not survive are horizontal. Vertical surprises are accelerometers that
// drop out, and feet that land.
void PushObserver::update(const Gains& gains, const Vector3& unexplained, bool carried,
                          double dt) noexcept {
  const Vector3 more = unexplained - smooth_;
  const double time = gains.push_time * share_of_time(gains, more.head<2>().norm(), carried, dt);
  smooth_.head<2>() += dt / (dt + time) * more.head<2>();
  smooth_.z() += dt / (dt + gains.push_time) * more.z();
}

// What surprises on and on is the body's own sway, at more delay than was told of: believed that
// soon, it would go on for good. So would legs that hang from a hand, which bear nothing of a plan
// that counts on feet.
double PushObserver::share_of_time(const Gains& gains, double surprise, bool carried,
                                   double dt) noexcept {
  const double beyond = surprise - kNoise * gains.push_dead_band;
  surprised_ = std::clamp(surprised_ + (beyond > 0.0 ? dt : -kForget * dt), 0.0, kAlert);
  if (beyond <= 0.0 || surprised_ >= kAlert || !carried) return 1.0;
  const double half = kSooner * gains.push_dead_band;
  return std::max(half / (half + beyond), kSoonest);
}

Vector3 PushObserver::acceleration(const Gains& gains) const noexcept {
  const double size = smooth_.norm();
  const double believed = std::clamp(size - gains.push_dead_band, 0.0, gains.push_max);
  return size > 0.0 ? Vector3(believed / size * smooth_) : Vector3::Zero();
}

}  // namespace surefoot
