// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dynamics/dynamics.hpp"
#include "scenes.hpp"
#include "wbc/condensation.hpp"

inline surefoot::Dynamics dynamics_at(const surefoot::Robot& robot,
                                      const surefoot::RobotState& state) {
  surefoot::Dynamics dynamics(robot);
  dynamics.update(state.q, state.v, surefoot::Vector3::UnitZ());
  return dynamics;
}

/// A robot, forces on its feet, and the motion they make: what the tasks' rows claim to know.
struct Pushed {
  static constexpr double kStep = 1e-6;  // [s] of the finite differences

  surefoot::Robot robot = quadruped();
  surefoot::RobotState state = random_state(robot, 5, 0.5);
  surefoot::Dynamics now = dynamics_at(robot, state);
  surefoot::Vector12 f;
  Eigen::VectorXd a;
  /// A push that feet and joints know nothing of, through the centre of mass, world axes [N].
  surefoot::Vector3 f_outside = surefoot::Vector3(20.0, -35.0, 8.0);

  Pushed() : a(robot.nv()) {
    surefoot::Condensed condensed;
    const surefoot::Vector6 outside = wrench_of_push();
    const bool regular = condense(now, surefoot::FeetMatrix::Zero(), outside, 1e-6, condensed);
    if (!regular) throw std::runtime_error("the test's pose is singular");
    std::srand(4);
    f = 30.0 * surefoot::Vector12::Random();
    a.head<6>() = condensed.B * f + condensed.c;
    const surefoot::Vector12 legs = condensed.leg_accelerations(a.head<6>());
    for (int i = 0; i < surefoot::kMotors; ++i) a[robot.motor_to_v()[i]] = legs[i];
  }

  /// The push as it acts on the base, in its axes.
  surefoot::Vector6 wrench_of_push() const {
    const surefoot::Vector3 arm = now.p_world_com() - now.p_world_base();
    surefoot::Vector6 wrench;
    wrench << now.R_world_base().transpose() * f_outside,
        now.R_world_base().transpose() * arm.cross(f_outside);
    return wrench;
  }

  surefoot::Dynamics after(double dt) const {
    surefoot::RobotState then = state;
    then.q = integrate(robot, state.q, dt * state.v + 0.5 * dt * dt * a);
    then.v += dt * a;
    return dynamics_at(robot, then);
  }

  /// Time derivative of something that Dynamics knows, along the motion.
  template <typename Quantity>
  surefoot::Vector3 rate(Quantity&& quantity) const {
    return (quantity(after(kStep)) - quantity(after(-kStep))) / (2.0 * kStep);
  }
};
