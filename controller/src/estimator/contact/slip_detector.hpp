// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/gains.hpp"
#include "surefoot/math.hpp"

namespace surefoot {

/// Motion of the feet of which SlipDetector::update() judges a slip.
struct FootSlipInput {
  const FeetMatrix& v_contact;     ///< velocities of the contact points, world axes [m/s]
  const Eigen::Vector4d& contact;  ///< contact confidence per foot, 0 .. 1
  const Eigen::Vector4d& loads;    ///< normal force of each foot / weight
  const Vector3& normal;           ///< of the ground, world axes
  /// true: feet step, or stepped lately. Soft soles sink and rise when their load changes, so only
  /// velocities along the ground count. A foot that lifts off moves before its contact confidence
  /// falls, so a foot counts only while it has load. Its slip confidence becomes 0 when it lifts
  /// off.
  bool stepping;
};

/// Detects loaded feet that move along the ground.
///
/// The detector compares the speed of each foot with that of the slowest loaded foot, because a
/// speed that all feet have in common is an error of the base velocity. Real-time: yes.
class SlipDetector {
 public:
  /// Process one tick.
  void update(const Gains& gains, const FootSlipInput& input, double dt) noexcept;

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
  /// Return the speeds of the contact points along the ground [m/s].
  Eigen::Vector4d sliding_speed(const FootSlipInput& input) const noexcept;
  /// Return each speed minus that of the slowest loaded foot, at least 0; 0 if no foot is loaded.
  Eigen::Vector4d excess(const Eigen::Vector4d& speed, const FootSlipInput& input) const noexcept;

  FeetMatrix v_filtered_ = FeetMatrix::Zero();
  Eigen::Vector4d speed_ = Eigen::Vector4d::Zero();
  Eigen::Vector4d excess_speed_ = Eigen::Vector4d::Zero();
  Eigen::Vector4d stance_time_ = Eigen::Vector4d::Zero();  // [s] time since touchdown
  Eigen::Vector4d slip_ = Eigen::Vector4d::Zero();
};

}  // namespace surefoot
