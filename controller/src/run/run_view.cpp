// SPDX-License-Identifier: BSD-3-Clause
#include "run/run_view.hpp"

#include <algorithm>
#include <cmath>

namespace surefoot {

void view_robot(const StandController& controller, const LowState& state, const Vector12& tau_max,
                RunSnapshot& now) noexcept {
  const RobotState& estimated = controller.state();
  const Reference& wanted = controller.reference();
  const Eigen::VectorXd& q = estimated.q;
  std::copy_n(q.data(), std::min<std::size_t>(now.q.size(), q.size()), now.q.begin());
  now.height = q[2];
  const double sine = std::hypot(q[3], q[4]);  // of half the tilt
  now.tilt = 2.0 * std::asin(std::min(sine, 1.0));
  now.distance = (wanted.p_base - q.head<3>()).norm();
  const Quaternion R_world_base(q[6], q[3], q[4], q[5]);
  now.angle = R_world_base.angularDistance(wanted.R_world_base);
  now.torque_ratio = 0.0;
  for (int i = 0; i < kMotors; ++i) {
    now.joints[i] = state.motorState[i].q;
    const double tau = std::abs(static_cast<double>(state.motorState[i].tauEst));
    now.torque_ratio = std::max(now.torque_ratio, tau / tau_max[i]);
  }
  now.command_power = controller.power();
  const auto& forces = controller.solution().forces;
  for (int leg = 0; leg < kLegs; ++leg) {
    for (int k = 0; k < 3; ++k) now.forces[3 * leg + k] = forces(k, leg);
    now.contact[leg] = estimated.contact[leg];
  }
}

}  // namespace surefoot
