// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dynamics/dynamics.hpp"
#include "surefoot/planner.hpp"

namespace surefoot {

/// Return the input of a planner; the parameters are its fields. `state`, `gains` and `dynamics`
/// must outlive the result. Real-time: yes.
inline PlannerInput make_planner_input(
    const RobotState& state, const Gains& gains, const Dynamics& dynamics, double dt, double delay,
    double mass, int lost_leg,
    const Eigen::Vector4d& sole_sink = Eigen::Vector4d::Zero()) noexcept {
  PlannerInput input{state,
                     gains,
                     dynamics,
                     dt,
                     delay,
                     mass,
                     dynamics.p_world_com(),
                     dynamics.v_world_com(),
                     dynamics.R_world_base(),
                     dynamics.w_world_base(),
                     contact_points(dynamics),
                     FeetMatrix(),
                     sole_sink,
                     lost_leg};
  for (int leg = 0; leg < kLegs; ++leg) {
    input.v_feet.col(leg) = dynamics.legs()[leg].v_world_contact;
  }
  return input;
}

}  // namespace surefoot
