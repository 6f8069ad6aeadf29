// SPDX-License-Identifier: BSD-3-Clause
#include "tasks/posture_task.hpp"

namespace surefoot {

void posture_accelerations(const Gains& gains, const JointTable& joints, const RobotState& state,
                           const Eigen::VectorXd& posture, Eigen::VectorXd& out) noexcept {
  for (int k = 0; k < static_cast<int>(joints.size()); ++k) {
    const JointRow& joint = joints[k];
    const double desired = posture.size() > 0 ? posture[joint.v - 6] : joint.q_standing;
    const double error = joint.q >= 0 ? desired - state.q[joint.q] : 0.0;
    out[k] = gains.posture_kp * error - gains.posture_kd * state.v[joint.v];
  }
}

}  // namespace surefoot
