// SPDX-License-Identifier: BSD-3-Clause
#include "run/robot_snapshot.hpp"

#include <algorithm>
#include <cmath>

namespace surefoot {

namespace {

// Return the mean height of the feet in stance, world frame [m]; 0 without one.
double stance_height(const Reference& reference) noexcept {
  double sum = 0.0;
  int count = 0;
  for (const FootReference& foot : reference.feet) {
    if (!foot.stance) continue;
    sum += foot.p_world.z();
    ++count;
  }
  return count > 0 ? sum / count : 0.0;
}

}  // namespace

void write_robot_snapshot(const WalkController& controller, const LowState& state,
                          const Vector12& tau_max, RunSnapshot& snapshot) noexcept {
  const RobotState& estimated = controller.state();
  const Reference& desired = controller.reference();
  const Eigen::VectorXd& q = estimated.q;
  std::copy_n(q.data(), std::min<std::size_t>(snapshot.q.size(), q.size()), snapshot.q.begin());
  snapshot.height = q[2] - stance_height(desired);
  const double sine = std::hypot(q[3], q[4]);  // sin(tilt / 2)
  snapshot.tilt = 2.0 * std::asin(std::min(sine, 1.0));
  snapshot.position_error = (desired.p_base - q.head<3>()).norm();
  const Quaternion R_world_base(q[6], q[3], q[4], q[5]);
  snapshot.orientation_error = R_world_base.angularDistance(desired.R_world_base);
  snapshot.torque_ratio = 0.0;
  for (int i = 0; i < kMotors; ++i) {
    snapshot.joint_angles[i] = state.motorState[i].q;
    const double tau = std::abs(static_cast<double>(state.motorState[i].tauEst));
    snapshot.torque_ratio = std::max(snapshot.torque_ratio, tau / tau_max[i]);
  }
  snapshot.commanded_velocity = controller.commanded_velocity();
  snapshot.reference_velocity = controller.reference_velocity();
  snapshot.velocity_limit = controller.velocity_limit();
  snapshot.command_power = controller.command_power();
  const auto& forces = controller.solution().forces;
  for (int leg = 0; leg < kLegs; ++leg) {
    for (int k = 0; k < 3; ++k) snapshot.desired_forces[3 * leg + k] = forces(k, leg);
    snapshot.contact[leg] = estimated.contact[leg];
  }
}

}  // namespace surefoot
