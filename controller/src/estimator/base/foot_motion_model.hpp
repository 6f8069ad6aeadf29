// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dynamics/dynamics.hpp"
#include "surefoot/gains.hpp"

namespace surefoot {

/// What is believed of the feet when the filter asks how far they may go.
struct FootContactState {
  Eigen::Vector4d contact;  ///< probability
  Eigen::Vector4d load;     ///< share of the weight, by torques; large where those tell nothing
  Eigen::Vector4d slip;     ///< how surely each slips, m/s: times its speed along the ground
  std::array<bool, kLegs> rejected;  ///< contradicted the filter beyond its gate
};

/// How contact points move from tick to tick: on purpose, as a sole rolls, and how far besides,
/// nobody knows where. Real-time: yes.
class FootMotionModel {
 public:
  /// Take in how the feet move relative to the base.
  void update_velocity(const Dynamics& dynamics, double dt) noexcept;

  /// What rolling has moved each contact point by since the last call [m], world axes: what the
  /// shank has turned by, times the lever. Of the joints' angles, for their velocities are noisy,
  /// and a contact point that trembles makes the filter's tilt and accelerometer bias walk.
  /// Joints count from the last call, the base over dt; the first call rolls nothing.
  /// @param q joints' angles, SDK order [rad]
  /// @param lever [m] from a contact point to its sole's centre, world axes
  FeetMatrix rolling_displacement(const Dynamics& dynamics, const Vector12& q,
                                  const Eigen::Vector4d& contact, const Vector3& lever,
                                  double dt) noexcept;

  /// Variance of where each may have gone besides [m^2]. Feet that bear no load, slip, or were
  /// refused may be anywhere soon; those that bear little slide easily.
  Eigen::Vector4d process_variance(const Gains& gains, const FootContactState& feet,
                                   double dt) const noexcept;

  void reset() noexcept { *this = FootMotionModel(); }

 private:
  Vector12 last_q_ = Vector12::Zero();  // [rad] of the last call
  bool has_last_q_ = false;
  FeetMatrix v_ = FeetMatrix::Zero();  // [m/s] relative to the base, smoothed
};

}  // namespace surefoot
