// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pushed_robot.hpp"
#include "wbc/form_selector.hpp"
#include "wbc/qp_units.hpp"

// A quadruped with joint limits so wide that they do not act in these tests.
inline surefoot::Robot wide_range_quadruped() {
  surefoot::RobotConfig config = quadruped_config();
  config.q_lower.setConstant(-3.0);
  config.q_upper.setConstant(3.0);
  return quadruped(config);
}

struct WideRangeRobot {
  using QpForm = surefoot::QpForm;
  surefoot::Robot robot = wide_range_quadruped();
  surefoot::RobotState state = standing_state(robot);
  surefoot::Dynamics dynamics = dynamics_at(robot, state);
  double min_determinant = surefoot::QpUnits(robot).smallest_determinant;
  surefoot::FormSelector selector{min_determinant};
  surefoot::Reference reference;

  void set(int motor, double angle) { state.q[robot.motor_to_q()[motor]] = angle; }
  QpForm select_form(QpForm wanted = QpForm::kAuto) {
    dynamics.update(state.q, state.v, surefoot::Vector3::UnitZ());
    return selector.update(dynamics, reference, wanted);
  }
  double determinant() const {
    return std::abs(dynamics.legs()[surefoot::FL_].J_leg.determinant());
  }
  bool within_torque_limits(const surefoot::Solution& s) const {
    return s.torques.allFinite() && s.torques.cwiseAbs().maxCoeff() <= 30.0 + 1e-9;
  }
};
