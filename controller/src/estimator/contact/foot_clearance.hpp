// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dynamics/dynamics.hpp"
#include "estimator/filter/invariant_filter.hpp"

namespace surefoot {

/// Foot clearance: height of each foot above the place where it last stood, along the ground
/// normal.
///
/// The height is relative to the plane of the other three feet, so that small errors of base tilt
/// and height cancel. Unless those three stand, the last value is kept.
///
/// The stance height of a foot is set when its forces first show load with three feet loaded, and
/// discarded when they show none. So neither a step onto a stone nor a landing counts as a rise. A
/// loaded foot that rests for 1 s takes its present height as stance height; flat ground is not
/// assumed. A foot with more clearance than soft ground yields is off the ground: a loaded foot may
/// slide, but does not rise. Real-time: yes.
class FootClearance {
 public:
  /// Process one tick.
  /// @param v_contact velocities of the contact points, world axes [m/s]
  /// @param contact contact confidence per foot @param loaded whether its forces show load
  void update(const Dynamics& dynamics, const InvariantFilter& filter, const FeetMatrix& v_contact,
              const Eigen::Vector4d& contact, const std::array<bool, kLegs>& loaded,
              const Vector3& normal, double dt) noexcept;

  const Eigen::Vector4d& clearance() const noexcept { return clearance_; }  ///< [m]
  void reset() noexcept { *this = FootClearance(); }

 private:
  Eigen::Vector4d stance_height_ = Eigen::Vector4d::Constant(NAN);  // [m] NaN: none
  Eigen::Vector4d rest_time_ = Eigen::Vector4d::Zero();             // [s]
  Eigen::Vector4d unloaded_time_ = Eigen::Vector4d::Zero();         // [s]
  double plane_time_ = 0.0;                                         // [s] with three feet loaded
  Eigen::Vector4d clearance_ = Eigen::Vector4d::Zero();
};

}  // namespace surefoot
