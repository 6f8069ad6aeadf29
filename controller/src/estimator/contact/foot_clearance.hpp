// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dynamics/dynamics.hpp"
#include "estimator/filter/invariant_filter.hpp"

namespace surefoot {

/// Foot clearance: height of each foot above the place where it last stood, measured along the
/// ground normal.
///
/// The height is measured relative to the plane of the three other feet, so that small errors of
/// base tilt and height cancel. While one of these three feet does not stand, the last value is
/// kept.
///
/// The stance height of a foot is the height of the place where it last stood. It is discarded
/// after 30 ms without load, and set again when the foot is loaded again. Until three feet have
/// been loaded for 50 ms, the stance heights follow the loaded feet. So neither a step onto a stone
/// nor a landing counts as a rise. After 1 s at rest, the stance height of a loaded foot follows
/// the foot. The ground need not be flat.
///
/// A loaded foot may slide, but it does not rise. So a foot is off the ground if its clearance
/// exceeds what soft ground can yield. Real-time: yes.
class FootClearance {
 public:
  /// Process one tick.
  /// @param v_contact velocities of the contact points, world axes [m/s]
  /// @param contact contact confidence per foot, 0 .. 1
  /// @param loaded true for each foot that is loaded according to its force sources
  /// @param normal ground normal, unit length, world axes
  void update(const Dynamics& dynamics, const InvariantFilter& filter, const FeetMatrix& v_contact,
              const Eigen::Vector4d& contact, const std::array<bool, kLegs>& loaded,
              const Vector3& normal, double dt) noexcept;

  const Eigen::Vector4d& clearance() const noexcept { return clearance_; }  ///< [m]
  void reset() noexcept { *this = FootClearance(); }

 private:
  Eigen::Vector4d stance_height_ = Eigen::Vector4d::Constant(NAN);  // [m] NaN: not set
  Eigen::Vector4d rest_time_ = Eigen::Vector4d::Zero();             // [s]
  Eigen::Vector4d unloaded_time_ = Eigen::Vector4d::Zero();         // [s]
  double plane_time_ = 0.0;  // [s] time for which three feet have been loaded
  Eigen::Vector4d clearance_ = Eigen::Vector4d::Zero();
};

}  // namespace surefoot
