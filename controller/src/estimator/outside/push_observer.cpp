// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/outside/push_observer.hpp"

#include <algorithm>

namespace surefoot {

namespace {
constexpr double kSurprise = 1.5;   // [m/s^2] beyond what was felt: more is no noise, a push began
constexpr double kSooner = 0.5;     // [m/s^2] more than that: it is believed in half the time
constexpr double kSoonest = 0.006;  // [s] a single wrong sample is not to be believed whole
}  // namespace

// Pushes that a stand may not survive are horizontal. Vertical surprises are accelerometers that
// drop out, and feet that land.
void PushObserver::update(const Gains& gains, const Vector3& unexplained, double dt) noexcept {
  const Vector3 more = unexplained - smooth_;
  const double surprise = std::max(0.0, more.head<2>().norm() - kSurprise);
  const double soonest = std::min(gains.push_time, kSoonest);
  const double time = std::max(gains.push_time / (1.0 + surprise / kSooner), soonest);
  smooth_.head<2>() += dt / (dt + time) * more.head<2>();
  smooth_.z() += dt / (dt + gains.push_time) * more.z();
}

Vector3 PushObserver::acceleration(const Gains& gains) const noexcept {
  const double size = smooth_.norm();
  const double believed = std::clamp(size - gains.push_dead_band, 0.0, gains.push_max);
  return size > 0.0 ? Vector3(believed / size * smooth_) : Vector3::Zero();
}

}  // namespace surefoot
