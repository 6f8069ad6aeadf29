// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/base/foot_noise.hpp"

#include <algorithm>
#include <cmath>

namespace surefoot {

namespace {
constexpr double kTimeConstant =
    0.02;  // [s] in which the variance falls by e when nothing surprises
constexpr double kMaxNisRatio = 25.0;  // times the dimension: a wilder innovation counts no more
constexpr double kMaxLogChange = 1.0;  // most that one sample changes the logarithm by
constexpr double kMinSigma = 2e-6;     // [m] nobody knows a foot better
constexpr double kMaxSigma = 0.02;     // [m]
}  // namespace

void FootNoise::reset(const Gains& gains) noexcept {
  variance_.setConstant(gains.noise_foot_position * gains.noise_foot_position);
}

void FootNoise::update(const Eigen::Vector4d& nis, const Eigen::Vector4d& predicted_variance,
                       const std::array<bool, kLegs>& stance, double dt) noexcept {
  for (int leg = 0; leg < kLegs; ++leg) {
    if (!stance[leg]) continue;
    // While the filter itself is in doubt, innovations say little of the measurement.
    const double share = variance_[leg] / (variance_[leg] + predicted_variance[leg]);
    const double excess = std::min(nis[leg] / 3.0, kMaxNisRatio) - 1.0;
    const double growth =
        std::clamp(dt / kTimeConstant * share * excess, -kMaxLogChange, kMaxLogChange);
    const double changed = variance_[leg] * std::exp(growth);
    variance_[leg] = std::clamp(changed, kMinSigma * kMinSigma, kMaxSigma * kMaxSigma);
  }
}

}  // namespace surefoot
