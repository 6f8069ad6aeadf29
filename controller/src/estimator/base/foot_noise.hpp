// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/gains.hpp"
#include "surefoot/math.hpp"

namespace surefoot {

/// How well each foot's position fits, measured: by the innovations' own size.
///
/// What the joint angles say of a foot is off by encoders, bending legs and soft soles, none of
/// which a data sheet tells. A foot's variance grows while its normalised innovation squared is
/// above its dimension and shrinks while it is below, exponentially, so that a guess that is wrong
/// by orders of magnitude is mended in a fraction of a second (innovation-based adaptation as in
/// Mehra 1970, by stochastic approximation). Real-time: yes.
class FootNoise {
 public:
  void reset(const Gains& gains) noexcept;

  /// Learn from feet that stand.
  /// @param nis normalised innovation squared of each foot, dimension 3
  /// @param predicted_variance variance of each innovation without the measurement's own [m^2]
  void update(const Eigen::Vector4d& nis, const Eigen::Vector4d& predicted_variance,
              const std::array<bool, kLegs>& stance, double dt) noexcept;

  /// Of one coordinate of each foot's position [m^2].
  const Eigen::Vector4d& variance() const noexcept { return variance_; }

 private:
  Eigen::Vector4d variance_ = Eigen::Vector4d::Zero();
};

}  // namespace surefoot
