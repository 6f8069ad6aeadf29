// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dynamics/dynamics.hpp"
#include "surefoot/gains.hpp"

namespace surefoot {

/// Contact state of the feet, which determines their process noise in the filter.
struct FootContactState {
  Eigen::Vector4d contact;  ///< contact confidence, 0 .. 1
  /// Load from torques, as a share of the weight; 1 if the torques are invalid.
  Eigen::Vector4d load;
  Eigen::Vector4d speed;              ///< [m/s] of the contact point on the ground
  bool steps;                         ///< true: the robot steps, see StepDetector
  std::array<bool, kLegs> rejected;   ///< true if the innovation gate rejected the foot
  Eigen::Vector4d at_friction_limit;  ///< FrictionEstimate::at_limit(), 0 .. 1
};

/// Motion of the contact points from tick to tick: the known displacement by rolling of the
/// spherical feet, and process noise for the unknown motion of feet that slip or swing. Real-time:
/// yes.
class FootMotionModel {
 public:
  /// Update the velocities of the feet relative to the base.
  void update_velocity(const Dynamics& dynamics, double dt) noexcept;

  /// Compute the displacement of each contact point by rolling since the last call. It is (rotation
  /// of the shank) x lever, times the contact confidence.
  ///
  /// The rotation of the shank is the rotation of the base over dt plus the change of the joint
  /// angles since the last call. Joint velocities are not used: their noise would move the contact
  /// points, and the filter's tilt and accelerometer bias would drift.
  /// @param q joint angles, SDK motor order [rad]
  /// @param contact contact confidence per foot, 0 .. 1
  /// @param lever vectors from the contact points to the centres of the feet, world axes [m]
  /// @return displacements FR FL RR RL, world axes [m]; zero at the first call
  FeetMatrix rolling_displacement(const Dynamics& dynamics, const Vector12& q,
                                  const Eigen::Vector4d& contact, const FeetMatrix& lever,
                                  double dt) noexcept;

  /// Compute the process noise of each contact point over dt, as the variance of one coordinate
  /// [m^2]. The noise is large for feet that are off the ground, slip, may slip or were rejected.
  /// It is larger for feet that carry less load.
  Eigen::Vector4d process_variance(const Gains& gains, const FootContactState& feet,
                                   double dt) const noexcept;

  void reset() noexcept { *this = FootMotionModel(); }

 private:
  Vector12 last_q_ = Vector12::Zero();  // [rad] joint angles of the last call
  bool has_last_q_ = false;
  // [m/s] Velocities of the feet relative to the base, low-passed.
  FeetMatrix v_ = FeetMatrix::Zero();
};

}  // namespace surefoot
