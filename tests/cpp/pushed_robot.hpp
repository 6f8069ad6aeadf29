// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dynamics/dynamics.hpp"
#include "robot_states.hpp"
#include "wbc/condensation.hpp"

inline surefoot::Dynamics dynamics_at(const surefoot::Robot& robot,
                                      const surefoot::RobotState& state) {
  surefoot::Dynamics dynamics(robot);
  dynamics.update(state.q, state.v, surefoot::Vector3::UnitZ());
  return dynamics;
}

/// A robot, forces on its feet, and the accelerations that they cause. Tests compare the rows of
/// tasks with this motion.
struct PushedRobot {
  static constexpr double kStep = 1e-6;  // [s] step of the finite differences

  surefoot::Robot robot = quadruped();
  surefoot::RobotState state = random_state(robot, 5, 0.5);
  surefoot::Dynamics dynamics = dynamics_at(robot, state);
  surefoot::Vector12 f;
  Eigen::VectorXd a;
  /// External force through the centre of mass, world axes [N]. Feet and joints do not measure it.
  surefoot::Vector3 f_external = surefoot::Vector3(20.0, -35.0, 8.0);

  PushedRobot() : a(robot.nv()) {
    surefoot::Condensed condensed;
    const surefoot::Vector6 external_wrench = push_wrench();
    const bool regular =
        condense(dynamics, surefoot::FeetMatrix::Zero(), external_wrench, 1e-6, condensed);
    if (!regular) throw std::runtime_error("the test's pose is singular");
    std::srand(4);
    f = 30.0 * surefoot::Vector12::Random();
    a.head<6>() = condensed.B * f + condensed.c;
    const surefoot::Vector12 legs = condensed.leg_accelerations(a.head<6>());
    for (int i = 0; i < surefoot::kMotors; ++i) a[robot.motor_to_v()[i]] = legs[i];
  }

  /// Return the wrench of the external force on the base, base axes.
  surefoot::Vector6 push_wrench() const {
    const surefoot::Vector3 arm = dynamics.p_world_com() - dynamics.p_world_base();
    surefoot::Vector6 wrench;
    wrench << dynamics.R_world_base().transpose() * f_external,
        dynamics.R_world_base().transpose() * arm.cross(f_external);
    return wrench;
  }

  surefoot::Dynamics dynamics_after(double dt) const {
    surefoot::RobotState next = state;
    next.q = integrate(robot, state.q, dt * state.v + 0.5 * dt * dt * a);
    next.v += dt * a;
    return dynamics_at(robot, next);
  }

  /// Return the time derivative of a quantity of Dynamics along the motion, by central differences.
  template <typename Quantity>
  surefoot::Vector3 rate(Quantity&& quantity) const {
    return (quantity(dynamics_after(kStep)) - quantity(dynamics_after(-kStep))) / (2.0 * kStep);
  }
};
