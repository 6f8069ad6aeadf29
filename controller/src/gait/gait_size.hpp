// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/math.hpp"
#include "surefoot/robot.hpp"
#include "surefoot/walk_velocity.hpp"

namespace surefoot {

/// Size of a robot, the unit of all lengths and times of its gait.
struct GaitSize {
  explicit GaitSize(const Robot& robot);

  FeetMatrix nominal_feet;  ///< [m] from the centre of mass, standing pose, base axes
  Vector3 nominal_base;     ///< [m] origin of the base from the centre of mass, base axes
  double height;            ///< [m] h: centre of mass above the feet, standing pose
  double corner_speed;      ///< [rad/s] of the thigh motors: RobotConfig::corner_speed
  double time;              ///< [s] sqrt(h / g), the time constant of the inverted pendulum
  double speed;             ///< [m/s] sqrt(g h)

  /// Return the speed of the fastest hip [m/s]. Real-time: yes.
  double fastest_hip(const WalkVelocity& velocity) const noexcept;
};

}  // namespace surefoot
