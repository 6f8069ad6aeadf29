// SPDX-License-Identifier: BSD-3-Clause
#include "tasks/foot_task.hpp"

#include <algorithm>

namespace surefoot {

namespace {

// [1/s] Damping of a stance foot without load; its stiffness makes it critically damped. Chosen:
// the foot of a leg with a joint damping of 2 N.m.s/rad, or a friction of 1.4 N.m, follows a pushed
// body half as far as with foot_kd = 50. If larger: with a latency of 20 ms the legs vibrate.
constexpr double kUnloadedKd = 140.0;
constexpr double kUnloadedKp = kUnloadedKd * kUnloadedKd / 4.0;
// [m g] Planned load from which the gains apply. Chosen: the friction of a foot with this load is
// larger than the force of joint friction.
constexpr double kLoaded = 0.1;
// [m/s^2] Largest acceleration by which the stiffer feedback exceeds that of the gains: 1.5 cm. A
// foot further away has been kicked, and the body must not pay for its return.
constexpr double kLargestExtra = 50.0;

}  // namespace

FeetMatrix feet_accelerations(const Gains& gains, const Reference& reference,
                              const Dynamics& dynamics, const Eigen::Vector4d& unloaded) noexcept {
  const double extra_kp = std::max(kUnloadedKp - gains.foot_kp, 0.0);
  const double extra_kd = std::max(kUnloadedKd - gains.foot_kd, 0.0);
  FeetMatrix a;
  for (int leg = 0; leg < kLegs; ++leg) {
    const FootReference& foot = reference.feet[leg];
    const Vector3 p_error = foot.p_world - dynamics.legs()[leg].p_world_contact;
    const Vector3 v_error = foot.v_world - dynamics.legs()[leg].v_world_contact;
    a.col(leg) = foot.a_world + gains.foot_kp * p_error + gains.foot_kd * v_error;
    if (!foot.stance) continue;
    const Vector3 extra = extra_kp * p_error + extra_kd * v_error;
    a.col(leg) += unloaded[leg] * std::min(1.0, kLargestExtra / (extra.norm() + 1e-9)) * extra;
  }
  return a;
}

Eigen::Vector4d unloaded_shares(const Eigen::Vector4d& loads,
                                const Eigen::Vector4d& contact) noexcept {
  const auto missing = (1.0 - loads.array() / kLoaded).min(1.0);
  return missing.min(contact.array()).max(0.0);
}

}  // namespace surefoot
