// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/filter/foot_noise.hpp"

#include <algorithm>
#include <cmath>

namespace surefoot {

namespace {
// The method is from Mehra 1970; the values are chosen unless stated.
//
// [s] Time constant with which the variance decays if all innovations are zero and the predicted
// variance is small. Ten samples at 500 Hz, and shorter than an impact.
constexpr double kTimeConstant = 0.02;
// Upper limit of the normalised innovation squared, in units of its dimension; larger values count
// as this limit. Derived: the square of five standard deviations.
constexpr double kMaxNisRatio = 25.0;
// Largest change of log(variance) in one sample: a factor of e = 2.7 in the variance.
constexpr double kMaxLogChange = 1.0;
// [m] Lower bound of the standard deviation. Derived: encoder steps of 3e-5 rad at a distance of
// 0.2 m move a foot in steps of 6e-6 m; their quantisation noise is 6e-6 / sqrt(12) m.
constexpr double kMinSigma = 2e-6;
// [m] Upper bound of the standard deviation. Derived: ten times noise_foot_position.
constexpr double kMaxSigma = 0.02;
}  // namespace

void FootNoise::reset(const Gains& gains) noexcept {
  variance_.setConstant(gains.noise_foot_position * gains.noise_foot_position);
}

void FootNoise::update(const Eigen::Vector4d& nis, const Eigen::Vector4d& predicted_variance,
                       const std::array<bool, kLegs>& stance, double dt) noexcept {
  for (int leg = 0; leg < kLegs; ++leg) {
    if (!stance[leg]) continue;
    // If the predicted variance is much larger than the measurement noise, innovations contain
    // little information about this noise.
    const double measurement_share = variance_[leg] / (variance_[leg] + predicted_variance[leg]);
    const double excess = std::min(nis[leg] / 3.0, kMaxNisRatio) - 1.0;
    const double growth =
        std::clamp(dt / kTimeConstant * measurement_share * excess, -kMaxLogChange, kMaxLogChange);
    const double new_variance = variance_[leg] * std::exp(growth);
    variance_[leg] = std::clamp(new_variance, kMinSigma * kMinSigma, kMaxSigma * kMaxSigma);
  }
}

}  // namespace surefoot
