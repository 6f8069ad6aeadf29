// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dynamics/dynamics.hpp"
#include "surefoot/gains.hpp"

namespace surefoot {

/// Contact state of the feet, which determines their process noise in the filter.
struct FootContactState {
  Eigen::Vector4d contact;           ///< contact confidence, 0 .. 1
  Eigen::Vector4d load;              ///< share of the weight, by torques; 1 without torques
  Eigen::Vector4d slip;              ///< [m/s] slip confidence times speed of the contact point
  std::array<bool, kLegs> rejected;  ///< rejected by the innovation gate
};

/// Motion of the contact points between ticks: displacement by rolling of the spherical feet, which
/// is known, and process noise for slip and swing, which is not. Real-time: yes.
class FootMotionModel {
 public:
  /// Update the velocities of the feet relative to the base.
  void update_velocity(const Dynamics& dynamics, double dt) noexcept;

  /// Compute the displacement [m] of each contact point by rolling since the last call, world axes:
  /// rotation of the shank x lever, times the contact confidence.
  ///
  /// The rotation comes from joint angles. Joint velocities are too noisy: jitter of the contact
  /// points makes the filter's tilt and accelerometer bias drift. The base rotates over dt, the
  /// joints since the last call; the first call returns zero.
  /// @param q joint angles, SDK order [rad]
  /// @param lever [m] from a contact point to the centre of its foot, world axes
  FeetMatrix rolling_displacement(const Dynamics& dynamics, const Vector12& q,
                                  const Eigen::Vector4d& contact, const Vector3& lever,
                                  double dt) noexcept;

  /// Compute the process noise [m^2] of each contact point over dt. It is large for feet that are
  /// off the ground, slip, or were rejected, and grows as the load of a foot falls.
  Eigen::Vector4d process_variance(const Gains& gains, const FootContactState& feet,
                                   double dt) const noexcept;

  void reset() noexcept { *this = FootMotionModel(); }

 private:
  Vector12 last_q_ = Vector12::Zero();  // [rad] in the last call
  bool has_last_q_ = false;
  FeetMatrix v_ = FeetMatrix::Zero();  // [m/s] relative to the base, filtered
};

}  // namespace surefoot
