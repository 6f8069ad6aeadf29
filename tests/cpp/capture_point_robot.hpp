// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pushed_robot.hpp"
#include "surefoot/whole_body_controller.hpp"

namespace surefoot {

// A level standing robot. Only the velocity of the body moves its capture point.
struct CapturePointRobot {
  Robot robot = quadruped();
  Gains gains;
  double weight = robot.mass() * kGravity;
  RobotState state = standing_state(robot);
  Reference reference = reference_at(robot, state);
  Dynamics dynamics = dynamics_at(robot, state);

  // Move the whole robot at one velocity, so that the base and the centre of mass share it.
  void set_com_velocity(const Vector3& speed) {
    state.v.head<3>() =
        Quaternion(state.q[6], state.q[3], state.q[4], state.q[5]).conjugate() * speed;
    dynamics.update(state.q, state.v, Vector3::UnitZ());
  }
  // Move the capture point `beyond` [m] to the right of the right feet, and half way to the front
  // feet, so that it is nearer to the front foot than to the rear foot.
  void move_capture_point_right(double beyond) {
    const FeetMatrix feet = contact_points(dynamics);
    const Vector3 com = dynamics.p_world_com();
    const double ahead = 0.5 * (feet(0, FR_) - com.x());
    set_com_velocity(omega() * Vector3(ahead, feet(1, FR_) - com.y() - beyond, 0.0));
  }
  double omega() const { return std::sqrt(kGravity / dynamics.p_world_com().z()); }
};

}  // namespace surefoot
