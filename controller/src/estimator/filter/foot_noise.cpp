// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/filter/foot_noise.hpp"

#include <algorithm>
#include <cmath>

namespace surefoot {

namespace {
// Noise by the size of the innovations: Mehra 1970. The values are chosen:
// [s] Time constant of the decay without innovations. Below: ten samples at 500 Hz; above: an
// impact.
constexpr double kTimeConstant = 0.02;
// Times the dimension: larger innovations are clipped. Derived: the square of five standard
// deviations.
constexpr double kMaxNisRatio = 25.0;
constexpr double kMaxLogChange = 1.0;  // one sample changes the variance by e = 2.7 times at most
// [m] Lower bound. Derived: quantisation noise of encoder steps of 3e-5 rad at 0.2 m, 6e-6 /
// sqrt(12).
constexpr double kMinSigma = 2e-6;
constexpr double kMaxSigma = 0.02;  // [m] upper bound; derived: ten times noise_foot_position
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
