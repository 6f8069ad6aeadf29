// SPDX-License-Identifier: BSD-3-Clause
#include "tasks/momentum_task.hpp"

namespace surefoot {

BodyRows momentum_task(const Gains& gains, const Reference& reference,
                       const Dynamics& dynamics) noexcept {
  BodyRows rows;
  for (int leg = 0; leg < kLegs; ++leg) {
    const Vector3 arm = dynamics.legs()[leg].p_world_contact - dynamics.p_world_com();
    rows.A_force.middleCols<3>(3 * leg) = skew(arm);
  }
  rows.b = reference.Ldot_com + gains.momentum_kd * (reference.L_com - dynamics.L_world_com());
  rows.weight.setConstant(gains.weight_momentum);
  return rows;
}

}  // namespace surefoot
