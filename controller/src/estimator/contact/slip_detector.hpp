// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/gains.hpp"
#include "surefoot/math.hpp"

namespace surefoot {

/// Detects loaded feet that move along the ground.
///
/// The detector compares the speed of each foot with that of the slowest loaded foot, because a
/// speed that all feet have in common is an error of the base velocity. Real-time: yes.
class SlipDetector {
 public:
  /// Process one tick.
  /// @param v_contact velocities of the contact points, world axes [m/s]
  /// @param contact contact confidence per foot, 0 .. 1
  /// @param stepping true: the slip confidence becomes 0 when a foot lifts off
  void update(const Gains& gains, const FeetMatrix& v_contact, const Eigen::Vector4d& contact,
              bool stepping, double dt) noexcept;

  /// Slip confidence of each foot, 0 .. 1.
  const Eigen::Vector4d& slip() const noexcept { return slip_; }
  /// Speeds of the contact points, low-pass filtered [m/s].
  const Eigen::Vector4d& speed() const noexcept { return speed_; }
  /// Velocities of the contact points, low-pass filtered, world axes [m/s].
  const FeetMatrix& velocity() const noexcept { return v_filtered_; }
  /// Speed of each foot minus the speed of the slowest loaded foot [m/s], at least 0. It is 0 while
  /// no foot is loaded.
  const Eigen::Vector4d& excess_speed() const noexcept { return excess_speed_; }
  /// Compute the share of the friction coefficient that each foot may use, 0 .. 1.
  Eigen::Vector4d friction(const Gains& gains) const noexcept {
    return Eigen::Vector4d::Ones() - (1.0 - gains.slip_friction) * slip_;
  }

  void reset() noexcept { *this = SlipDetector(); }

 private:
  FeetMatrix v_filtered_ = FeetMatrix::Zero();
  Eigen::Vector4d speed_ = Eigen::Vector4d::Zero();
  Eigen::Vector4d excess_speed_ = Eigen::Vector4d::Zero();
  Eigen::Vector4d stance_time_ = Eigen::Vector4d::Zero();  // [s] time since touchdown
  Eigen::Vector4d slip_ = Eigen::Vector4d::Zero();
};

}  // namespace surefoot
