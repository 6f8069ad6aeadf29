// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/filter/foot_noise.hpp"

#include <algorithm>
#include <cmath>

namespace surefoot {

namespace {
constexpr double kTimeConstant = 0.02;  // [s] time constant of the decay without innovations
constexpr double kMaxNisRatio = 25.0;   // times the dimension: larger innovations are clipped
constexpr double kMaxLogChange = 1.0;   // largest change of log(variance) by one sample
constexpr double kMinSigma = 2e-6;      // [m] lower bound
constexpr double kMaxSigma = 0.02;      // [m] upper bound
}  // namespace

void FootNoise::reset(const Gains& gains) noexcept {
  variance_.setConstant(gains.noise_foot_position * gains.noise_foot_position);
}

void FootNoise::update(const Eigen::Vector4d& nis, const Eigen::Vector4d& predicted_variance,
                       const std::array<bool, kLegs>& stance, double dt) noexcept {
  for (int leg = 0; leg < kLegs; ++leg) {
    if (!stance[leg]) continue;
    // While the predicted variance dominates, innovations tell little about the measurement noise.
    const double share = variance_[leg] / (variance_[leg] + predicted_variance[leg]);
    const double excess = std::min(nis[leg] / 3.0, kMaxNisRatio) - 1.0;
    const double growth =
        std::clamp(dt / kTimeConstant * share * excess, -kMaxLogChange, kMaxLogChange);
    const double changed = variance_[leg] * std::exp(growth);
    variance_[leg] = std::clamp(changed, kMinSigma * kMinSigma, kMaxSigma * kMaxSigma);
  }
}

}  // namespace surefoot
