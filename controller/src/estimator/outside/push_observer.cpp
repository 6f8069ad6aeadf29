// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/outside/push_observer.hpp"

#include <algorithm>

namespace surefoot {

void PushObserver::update(const Gains& gains, const Vector3& unexplained, double dt) noexcept {
  smooth_ += dt / (dt + gains.push_time) * (unexplained - smooth_);
}

Vector3 PushObserver::acceleration(const Gains& gains) const noexcept {
  const double size = smooth_.norm();
  const double believed = std::clamp(size - gains.push_dead_band, 0.0, gains.push_max);
  return size > 0.0 ? Vector3(believed / size * smooth_) : Vector3::Zero();
}

}  // namespace surefoot
