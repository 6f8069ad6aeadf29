// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/gains.hpp"
#include "surefoot/math.hpp"

namespace surefoot {

/// Adaptive measurement noise of the foot positions.
///
/// Encoders, leg flexibility and soft soles cause errors of the foot position from joint angles,
/// and no data sheet gives their size. So the variance of each foot is adapted. It grows
/// exponentially while the normalised innovation squared of the foot is above 3, its dimension, and
/// decays while it is below 3. An initial variance that is wrong by orders of magnitude is
/// corrected within a fraction of a second. Method: innovation-based adaptation (Mehra 1970) in
/// small steps, one per sample (stochastic approximation). Real-time: yes.
class FootNoise {
 public:
  /// Set all variances to the square of the gain noise_foot_position.
  void reset(const Gains& gains) noexcept;

  /// Adapt the variances of the stance feet.
  /// @param nis normalised innovation squared of each foot, of dimension 3
  /// @param predicted_variance variance [m^2] of one coordinate of each innovation, without
  ///   measurement noise
  void update(const Eigen::Vector4d& nis, const Eigen::Vector4d& predicted_variance,
              const std::array<bool, kLegs>& stance, double dt) noexcept;

  /// Variance of one coordinate of each measured foot position [m^2], FR FL RR RL.
  const Eigen::Vector4d& variance() const noexcept { return variance_; }

 private:
  Eigen::Vector4d variance_ = Eigen::Vector4d::Zero();
};

}  // namespace surefoot
