// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/math.hpp"

namespace surefoot {

/// Loads from which the filter computes how far soft soles yield, as shares of the weight.
///
/// The noise of the loads of a standing robot must not move its feet, so load() then follows the
/// measured load only outside a band around it. changes() tells whether a foot takes up or loses
/// load. Real-time: yes.
class SoleLoad {
 public:
  /// Process one tick.
  /// @param load normal force of each foot / weight
  /// @param steps true: the robot steps, see StepDetector
  void update(const Eigen::Vector4d& load, bool steps, double dt) noexcept;

  const Eigen::Vector4d& load() const noexcept { return load_; }
  /// Return the variance [m^2] of the sinks that load() gives, because sink and load do not change
  /// at the same time.
  /// @param compliance depth by which a sole yields under the weight [m]
  Eigen::Vector4d sink_variance(double compliance, double dt) const noexcept;
  const std::array<bool, kLegs>& changes() const noexcept { return changes_; }
  /// Return the process noise of the sole compliance [m^2]: a robot that steps may step
  /// onto softer ground.
  /// @param radius of the feet [m]
  double process_variance(double radius, double dt) const noexcept;

  void reset() noexcept { *this = SoleLoad(); }

 private:
  Eigen::Vector4d load_ = Eigen::Vector4d::Constant(1.0 / kLegs);
  Eigen::Vector4d lagged_ = Eigen::Vector4d::Constant(1.0 / kLegs);
  Eigen::Vector4d mean_ = Eigen::Vector4d::Constant(1.0 / kLegs);
  std::array<bool, kLegs> changes_{};
  bool steps_ = false;
};

}  // namespace surefoot
