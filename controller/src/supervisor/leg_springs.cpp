// SPDX-License-Identifier: BSD-3-Clause
#include "supervisor/leg_springs.hpp"

#include <algorithm>

#include "safety/holding_torques.hpp"
#include "safety/power_limiter.hpp"

namespace surefoot {

namespace {
constexpr double kReach = 0.45;       // [rad] beyond which a spring pulls no harder
constexpr double kTorqueShare = 0.9;  // of what the motor can do
}  // namespace

LegSprings::LegSprings(const Robot& robot, const RisePlan& plan, double watts)
    : robot_(robot),
      dynamics_(robot),
      state_(robot.nq(), robot.nv()),
      stiffness_(plan.stiffness),
      damping_(plan.damping),
      watts_(watts) {}

void LegSprings::read(const LowState& state) noexcept {
  for (int i = 0; i < kMotors; ++i) {
    q_[i] = state.motorState[i].q;
    dq_[i] = state.motorState[i].dq;
    state_.q[robot_.motor_to_q()[i]] = q_[i];
  }
  const std::array<float, 4> imu = state.imu.quaternion;  // packed: copied
  const Eigen::Vector4d mount = robot_.config().quat_base_imu;
  const Quaternion R_world_imu(imu[0], imu[1], imu[2], imu[3]);
  const Quaternion R_base_imu(mount[0], mount[1], mount[2], mount[3]);
  const Quaternion R = (R_world_imu * R_base_imu.conjugate()).normalized();
  state_.q.segment<4>(3) = R.coeffs();
  cos_tilt_ = (R * Vector3::UnitZ()).z();
}

Vector12 LegSprings::torques(const JointReference& reference, double load) noexcept {
  dynamics_.update(state_.q, state_.v, Vector3::UnitZ());
  state_.f_lasting = (1.0 - load) * robot_.mass() * kGravity * Vector3::UnitZ();
  const Vector12 hold = holding_torques(dynamics_, robot_.mass(), state_, Eigen::Vector4d::Ones());
  const Vector12 pull = (reference.q - q_).cwiseMax(-kReach).cwiseMin(kReach);
  Vector12 tau = hold + stiffness_ * pull + damping_ * reference.dq;
  const RobotConfig& config = robot_.config();
  for (int i = 0; i < kMotors; ++i) {
    tau[i] = std::clamp(tau[i], -kTorqueShare * motor_torque_limit(config, i, dq_[i], -1.0),
                        kTorqueShare * motor_torque_limit(config, i, dq_[i], 1.0));
  }
  return limit_power(tau, hold, dq_, watts_, damping_).torques;
}

}  // namespace surefoot
