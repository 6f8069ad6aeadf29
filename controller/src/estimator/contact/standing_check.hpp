// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dynamics/dynamics.hpp"

namespace surefoot {

/// Motion of one tick from which StandingCheck judges whether still legs stand.
struct StandingCheckInput {
  /// True for each leg whose contact is assumed, because no sensor measures its force.
  const std::array<bool, kLegs>& assumed;
  Vector3 acceleration;  ///< [m/s^2] of the IMU point by the accelerometer, world axes
  Vector3 arm;           ///< [m] from the base origin to the IMU point, world axes
  double tilt_sigma;     ///< [rad] standard deviation of the tilt
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
  Eigen::Vector4d still_legs(const Dynamics& dynamics, double dt) noexcept;
  void compare_speed(const Vector3& gain, double dt) noexcept;
  bool contradicted(double tilt_sigma) const noexcept;

  FeetMatrix v_joints_ = FeetMatrix::Zero();     // [m/s] of the feet by the joints, low-passed
  Vector3 turn_ = Vector3::Zero();               // [rad] of the feet in the last second, world axes
  Vector3 speed_ = Vector3::Zero();              // [m/s] gained lately, without the legs
  Vector3 smooth_speed_ = Vector3::Zero();       // [m/s] low-passed
  Vector3 mean_acceleration_ = Vector3::Zero();  // [m/s^2] of the last seconds
  Vector3 last_v_legs_ = Vector3::Zero();        // [m/s] of the IMU point by the legs
  bool compared_ = false;                        // last_v_legs_ is of the last tick
  double refuted_time_ = 0.0;                    // [s] for which the legs remain refuted
  bool newly_refuted_ = false;
};

}  // namespace surefoot
