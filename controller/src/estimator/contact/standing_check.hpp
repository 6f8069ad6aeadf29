// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dynamics/dynamics.hpp"

namespace surefoot {

/// Motion of one tick from which StandingCheck judges whether still legs stand.
struct StandingCheckInput {
  /// True for each leg whose contact is assumed, because no sensor measures its force.
  const std::array<bool, kLegs>& assumed;
  const Vector12& q;  ///< [rad] joint angles, SDK motor order
  Vector3 w_base;     ///< [rad/s] angular velocity without bias, base axes
  Vector3 f_base;     ///< [m/s^2] specific force, base axes
  Vector3 arm;        ///< [m] from the base origin to the IMU point, base axes
};

/// Refutes the assumption that legs stand whose forces no sensor measures.
///
/// Feet on the ground hold a body whose legs do not move. If the gyroscope or the accelerometer
/// shows that such a body turns or gains speed, it is carried, hangs or falls. The check compares
/// the sensors with at least three still legs, so it judges no robot that steps or balances.
/// Real-time: yes.
class StandingCheck {
 public:
  /// Process one tick.
  /// @param dynamics with the base at the origin and without linear velocity
  void update(const Dynamics& dynamics, const StandingCheckInput& input, double dt) noexcept;

  /// Return whether the legs do not stand. This lasts until the body has been still for a second.
  bool refuted() const noexcept { return refuted_time_ > 0.0; }
  /// Return whether the last update() refuted legs that were believed before.
  bool newly_refuted() const noexcept { return newly_refuted_; }
  void reset() noexcept { *this = StandingCheck(); }

 private:
  FeetMatrix joint_velocities(const Dynamics& dynamics, const Vector12& q, double dt) noexcept;
  Eigen::Vector4d still_legs(const FeetMatrix& v, double dt) noexcept;
  void compare_speed(const Vector3& force, const Vector3& v_legs, double dt) noexcept;
  bool contradicted() const noexcept;

  // Rotation of the base by the gyroscope alone. Vectors below are in the axes that it defines: the
  // attitude of the filter may be wrong because of wrong contacts.
  Quaternion rotation_ = Quaternion::Identity();
  Vector12 last_q_ = Vector12::Constant(NAN);  // [rad]
  FeetMatrix v_joints_ = FeetMatrix::Zero();   // [m/s] of the feet by the joints, low-passed
  Vector3 turn_ = Vector3::Zero();             // [rad] of the feet in the last second
  Vector3 speed_ = Vector3::Zero();            // [m/s] gained lately, without the legs
  Vector3 smooth_speed_ = Vector3::Zero();     // [m/s] low-passed
  Vector3 mean_force_ = Vector3::Zero();       // [m/s^2] specific force of the last seconds
  Vector3 last_v_legs_ = Vector3::Zero();      // [m/s] of the IMU point by the legs
  bool has_mean_ = false;
  bool compared_ = false;      // last_v_legs_ is of the last tick
  double refuted_time_ = 0.0;  // [s] for which the legs remain refuted
  bool newly_refuted_ = false;
};

}  // namespace surefoot
