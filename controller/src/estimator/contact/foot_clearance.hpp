// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dynamics/dynamics.hpp"
#include "estimator/base/invariant_filter.hpp"

namespace surefoot {

/// How far each foot has risen, along the ground's normal, from where it last stood still, out of
/// the plane that the other three make; nothing unless those stand, for then a tilt or a height of
/// the body that is wrong by a little would look the same; what was known before holds meanwhile.
///
/// It begins where the foot's forces first call it loaded, three feet bearing, and ends where they
/// call it lifted: a foot that steps onto a stone has not risen, nor has one of a robot that lands.
/// A foot may slide under load; it does not rise under load by more than the ground gives way. Feet
/// that rest and bear load for a while stand anew, wherever that is: no flat ground is assumed.
/// Real-time: yes.
class FootClearance {
 public:
  /// @param v_contact velocities of the contact points, world axes [m/s]
  /// @param contact belief per foot @param loaded do its forces say so?
  void update(const Dynamics& dynamics, const InvariantFilter& filter, const FeetMatrix& v_contact,
              const Eigen::Vector4d& contact, const std::array<bool, kLegs>& loaded,
              const Vector3& normal, double dt) noexcept;

  const Eigen::Vector4d& clearance() const noexcept { return clearance_; }  ///< [m]
  void reset() noexcept { *this = FootClearance(); }

 private:
  Eigen::Vector4d stance_height_ =
      Eigen::Vector4d::Constant(NAN);                        // [m] height where each last stood
  Eigen::Vector4d rest_time_ = Eigen::Vector4d::Zero();      // [s]
  Eigen::Vector4d unloaded_time_ = Eigen::Vector4d::Zero();  // [s]
  double plane_time_ = 0.0;                                  // [s] for which three feet have borne
  Eigen::Vector4d clearance_ = Eigen::Vector4d::Zero();
};

}  // namespace surefoot
