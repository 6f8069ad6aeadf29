// SPDX-License-Identifier: BSD-3-Clause
#include "tasks/foot_task.hpp"

#include <algorithm>

namespace surefoot {

namespace {

// [1/s] Smallest damping in the bound, used if foot_kd is smaller. Chosen larger than 0, because a
// bound of 0 would switch off the feedback of the foot position, and smaller than the foot_kd of
// all robots (46 to 65).
constexpr double kMinDamping = 1.0;

// Return foot_kp times the offset, limited to the acceleration that the damping balances at
// foot_speed.
Vector3 stiffness_acceleration(const Gains& gains, const Vector3& offset) noexcept {
  const Vector3 stiffness_term = gains.foot_kp * offset;
  const double max_norm = std::max(gains.foot_kd, kMinDamping) * gains.foot_speed;
  const double norm = stiffness_term.norm();
  return norm > max_norm ? Vector3(max_norm / norm * stiffness_term) : stiffness_term;
}

}  // namespace

FeetMatrix feet_accelerations(const Gains& gains, const Reference& reference,
                              const Dynamics& dynamics) noexcept {
  FeetMatrix a;
  for (int leg = 0; leg < kLegs; ++leg) {
    const FootReference& foot = reference.feet[leg];
    const LegDynamics& L = dynamics.legs()[leg];
    a.col(leg) = foot.a_world + stiffness_acceleration(gains, foot.p_world - L.p_world_contact) +
                 gains.foot_kd * (foot.v_world - L.v_world_contact);
  }
  return a;
}

}  // namespace surefoot
