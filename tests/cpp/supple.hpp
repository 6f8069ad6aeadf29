// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "motion.hpp"
#include "wbc/form_selector.hpp"
#include "wbc/program_layout.hpp"

// Joints with room for what no limit should keep from happening here.
inline surefoot::Robot supple() {
  surefoot::RobotConfig config = quadruped_config();
  config.q_lower.setConstant(-3.0);
  config.q_upper.setConstant(3.0);
  return quadruped(config);
}

struct Supple {
  using Form = surefoot::Form;
  surefoot::Robot robot = supple();
  surefoot::RobotState state = standing_state(robot);
  surefoot::Dynamics dynamics = dynamics_at(robot, state);
  double smallest = surefoot::ProgramUnits(robot).smallest_determinant;
  surefoot::FormSelector selector{smallest};
  surefoot::Reference reference;

  void set(int motor, double angle) { state.q[robot.motor_to_q()[motor]] = angle; }
  Form judge(Form wanted = Form::kAuto) {
    dynamics.update(state.q, state.v, surefoot::Vector3::UnitZ());
    return selector.update(dynamics, reference, wanted);
  }
  double determinant() const {
    return std::abs(dynamics.legs()[surefoot::FL_].J_leg.determinant());
  }
  bool inside_motors(const surefoot::Solution& s) const {
    return s.torques.allFinite() && s.torques.cwiseAbs().maxCoeff() <= 30.0 + 1e-9;
  }
};
