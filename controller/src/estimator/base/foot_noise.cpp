// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/base/foot_noise.hpp"

#include <algorithm>
#include <cmath>

namespace surefoot {

namespace {
constexpr double kTime = 0.02;      // [s] in which the variance falls by e when nothing surprises
constexpr double kSurprise = 25.0;  // times the dimension: a wilder innovation counts no more
constexpr double kStep = 1.0;       // most that one sample changes the logarithm by
constexpr double kLeast = 2e-6;     // [m] nobody knows a foot better
constexpr double kMost = 0.02;      // [m]
}  // namespace

void FootNoise::reset(const Gains& gains) noexcept {
  variance_.setConstant(gains.noise_foot_position * gains.noise_foot_position);
}

void FootNoise::update(const Eigen::Vector4d& nis, const Eigen::Vector4d& expected,
                       const std::array<bool, kLegs>& standing, double dt) noexcept {
  for (int leg = 0; leg < kLegs; ++leg) {
    if (!standing[leg]) continue;
    // While the filter itself is in doubt, innovations say little of the measurement.
    const double share = variance_[leg] / (variance_[leg] + expected[leg]);
    const double excess = std::min(nis[leg] / 3.0, kSurprise) - 1.0;
    const double growth = std::clamp(dt / kTime * share * excess, -kStep, kStep);
    const double changed = variance_[leg] * std::exp(growth);
    variance_[leg] = std::clamp(changed, kLeast * kLeast, kMost * kMost);
  }
}

}  // namespace surefoot
