// SPDX-License-Identifier: BSD-3-Clause
#include "wbc/own_limits.hpp"

#include <algorithm>

namespace surefoot {

namespace {
constexpr double kMore = 1e4;  // [rad/s^2] that no body asks of a leg
}

void let_go(const JointTable& joints, double fade, const Eigen::Vector4d& contact,
            const Reference& reference, JointLimits& limits) noexcept {
  for (std::size_t k = 0; k < joints.size(); ++k) {
    const int leg = joints[k].group;
    double bears = 1.0;
    if (leg < kLegs) {
      bears = planned_load(reference.feet[leg]) * std::clamp(contact[leg], 0.0, 1.0);
    }
    limits.more[k] = kMore * (1.0 - fade) * (1.0 - bears);
  }
}

void keep_own_limits(const JointTable& joints, const Dynamics& dynamics, const JointLimits& limits,
                     Eigen::VectorXd& accelerations, Eigen::VectorXd& torques) noexcept {
  for (int leg = 0; leg < kLegs; ++leg) {
    Vector3 change;
    for (int j = 0; j < 3; ++j) {
      const int k = 3 * leg + j;
      double& a = accelerations[joints[k].v];
      const double kept = std::clamp(a, limits.a_lower[k], limits.a_upper[k]);
      // No more than it was let go by: what a limit that all must keep gave way by is not its own.
      change[j] = std::clamp(kept - a, -limits.more[k], limits.more[k]);
      a += change[j];
    }
    if (!change.isZero(0.0)) torques.segment<3>(3 * leg) += dynamics.legs()[leg].M_leg * change;
  }
}

}  // namespace surefoot
