// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pushed_robot.hpp"
#include "surefoot/whole_body_controller.hpp"

namespace surefoot {

// Stands level; the capture point is moved by the body's speed alone.
struct CapturePointRobot {
  Robot robot = quadruped();
  Gains gains;
  double weight = robot.mass() * kGravity;
  RobotState state = standing_state(robot);
  Reference reference = reference_at(robot, state);
  Dynamics dynamics = dynamics_at(robot, state);

  // All mass moves alike when the whole robot does: v_com is the base's.
  void set_com_velocity(const Vector3& speed) {
    state.v.head<3>() =
        Quaternion(state.q[6], state.q[3], state.q[4], state.q[5]).conjugate() * speed;
    dynamics.update(state.q, state.v, Vector3::UnitZ());
  }
  // The capture point over the right feet, by how far it is beyond them; further ahead than behind.
  void move_capture_point_right(double beyond) {
    const FeetMatrix feet = contact_points(dynamics);
    const Vector3 com = dynamics.p_world_com();
    const double ahead = 0.5 * (feet(0, FR_) - com.x());
    set_com_velocity(omega() * Vector3(ahead, feet(1, FR_) - com.y() - beyond, 0.0));
  }
  double omega() const { return std::sqrt(kGravity / dynamics.p_world_com().z()); }
};

}  // namespace surefoot
