// SPDX-License-Identifier: BSD-3-Clause
#include "wbc/joint_limits.hpp"

#include <algorithm>

namespace surefoot {

void joint_limits(const RobotConfig& config, const JointTable& joints, const Gains& gains,
                  bool stepping, const Vector12& share, const RobotState& state,
                  JointLimits& out) noexcept {
  const double r = stepping ? gains.walk_joint_limit_rate : gains.joint_limit_rate;
  for (std::size_t k = 0; k < joints.size(); ++k) {
    const JointRow& joint = joints[k];
    const double dq = state.v[joint.v];
    const bool motor = joint.motor >= 0;
    const auto max_torque = [&](double sign) {
      return motor ? share[joint.motor] * motor_torque_limit(config, joint.motor, dq, sign)
                   : joint.tau_max;
    };
    out.tau_upper[k] = max_torque(1.0);
    out.tau_lower[k] = -max_torque(-1.0);

    double lower = -r * (joint.dq_max + dq);
    double upper = r * (joint.dq_max - dq);
    if (joint.q >= 0) {
      const double q = state.q[joint.q];
      lower = std::max(lower, r * r * (joint.q_lower + gains.joint_limit_margin - q) - 2 * r * dq);
      upper = std::min(upper, r * r * (joint.q_upper - gains.joint_limit_margin - q) - 2 * r * dq);
    }
    // Far outside the joint's range the two limits can contradict each other. Their mean is a
    // compromise.
    if (lower > upper) lower = upper = 0.5 * (lower + upper);
    out.a_lower[k] = lower;
    out.a_upper[k] = upper;
    out.a_widening[k] = 0.0;
  }
}

}  // namespace surefoot
