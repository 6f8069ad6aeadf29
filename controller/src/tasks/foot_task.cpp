// SPDX-License-Identifier: BSD-3-Clause
#include "tasks/foot_task.hpp"

namespace surefoot {

FeetMatrix feet_accelerations(const Gains& gains, const Reference& reference,
                              const Dynamics& dynamics) noexcept {
  FeetMatrix a;
  for (int leg = 0; leg < kLegs; ++leg) {
    const FootReference& foot = reference.feet[leg];
    const LegDynamics& L = dynamics.legs()[leg];
    a.col(leg) = foot.a_world + gains.foot_kp * (foot.p_world - L.p_world_contact) +
                 gains.foot_kd * (foot.v_world - L.v_world_contact);
  }
  return a;
}

}  // namespace surefoot
