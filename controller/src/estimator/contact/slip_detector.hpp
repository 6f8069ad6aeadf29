// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/gains.hpp"
#include "surefoot/math.hpp"

namespace surefoot {

/// Sees a foot that bears load and moves along the ground. Real-time: yes.
///
/// Speeds are against the slowest loaded foot: what all feet share is an error of the base's
/// velocity.
class SlipDetector {
 public:
  /// @param v_contact velocities of the contact points, world axes [m/s]
  /// @param contact belief per foot
  void update(const Gains& gains, const FeetMatrix& v_contact, const Eigen::Vector4d& contact,
              double dt) noexcept;

  /// How surely each foot slips, 0 .. 1.
  const Eigen::Vector4d& slip() const noexcept { return slip_; }
  /// Of the contact points, smoothed [m/s].
  const Eigen::Vector4d& speed() const noexcept { return speed_; }
  /// The same, world axes.
  const FeetMatrix& velocity() const noexcept { return v_filtered_; }
  /// The same beyond the slowest loaded foot's; 0 while none is loaded.
  const Eigen::Vector4d& excess_speed() const noexcept { return excess_speed_; }
  /// What is left of each foot's friction coefficient.
  Eigen::Vector4d friction(const Gains& gains) const noexcept {
    return Eigen::Vector4d::Ones() - (1.0 - gains.slip_friction) * slip_;
  }

  void reset() noexcept { *this = SlipDetector(); }

 private:
  FeetMatrix v_filtered_ = FeetMatrix::Zero();
  Eigen::Vector4d speed_ = Eigen::Vector4d::Zero();
  Eigen::Vector4d excess_speed_ = Eigen::Vector4d::Zero();
  Eigen::Vector4d stance_time_ = Eigen::Vector4d::Zero();  // [s] since touchdown
  Eigen::Vector4d slip_ = Eigen::Vector4d::Zero();
};

}  // namespace surefoot
