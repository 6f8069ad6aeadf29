// SPDX-License-Identifier: BSD-3-Clause
#include "supervisor/leg_springs.hpp"

#include <algorithm>
#include <cmath>

#include "safety/holding_torques.hpp"
#include "safety/motor_limits.hpp"
#include "safety/power_limiter.hpp"
#include "supervisor/motor_values.hpp"
#include "supervisor/smooth.hpp"

namespace surefoot {

namespace {
constexpr double kReach = 0.45;       // [rad] beyond which a spring pulls no harder
constexpr double kTorqueShare = 0.9;  // of what the motor can do
constexpr double kLiftShare = 0.75;   // of it for holding, where there is to be some for lifting
constexpr double kRuns = 2.0;         // [rad/s] faster than its reference: a joint lets go of ...
constexpr double kLetGo = 2.0;        // ... its spring within this much more
constexpr double kTurns = 0.6;        // [rad/s] faster: the body may fall, and legs brake less ...
constexpr double kFalls = 1.6;        // [rad/s] ... until here ...
constexpr double kGivesWay = 0.25;    // ... they brake this much of what they would
constexpr double kSmoothing = 0.02;   // [s] of that: no step of torque
constexpr double kBears = 0.1;        // of the body's weight: legs that bear so much are not caught
}  // namespace

LegSprings::LegSprings(const Robot& robot, const RisePlan& plan, double watts)
    : robot_(robot),
      dynamics_(robot),
      state_(robot.nq(), robot.nv()),
      stiffness_(plan.stiffness),
      full_damping_(plan.damping),
      damping_(plan.damping),
      watts_(watts) {
  R_base_imu_ = quaternion_wxyz(robot.config().quat_base_imu);
}

void LegSprings::read(const LowState& state) noexcept {
  dq_ = measured_speeds(state);
  for (int i = 0; i < kMotors; ++i) {
    q_[i] = state.motorState[i].q;
    state_.q[robot_.motor_to_q()[i]] = q_[i];
  }
  const std::array<float, 4> imu = state.imu.quaternion;  // packed: copied
  const Quaternion R_world_imu(imu[0], imu[1], imu[2], imu[3]);
  R_world_base_ = (R_world_imu * R_base_imu_.conjugate()).normalized();
  state_.q.segment<4>(3) = R_world_base_.coeffs();
}

void LegSprings::give_way(double turning, double dt) noexcept {
  const double falls = std::clamp((turning - kTurns) / (kFalls - kTurns), 0.0, 1.0);
  const double wanted = (1.0 - (1.0 - kGivesWay) * falls) * full_damping_;
  damping_ += dt / (dt + kSmoothing) * (wanted - damping_);
}

// A spring that pulls with tau and comes free takes (tau - D dq) dq, which is most at
// dq = tau / (2 D): tau^2 / (4 D).
Vector12 LegSprings::released_within_power(const Vector12& pull) const noexcept {
  const double released = (stiffness_ * pull).squaredNorm() / (4.0 * damping_);
  return pull * std::sqrt(std::min(1.0, watts_ / std::max(released, 1e-9)));
}

// At the pose that dynamics_ was last updated for.
Vector12 LegSprings::hold(double load) noexcept {
  state_.f_lasting = (1.0 - load) * robot_.mass() * kGravity * Vector3::UnitZ();
  return holding_torques(dynamics_, robot_.mass(), state_, Eigen::Vector4d::Ones());
}

bool LegSprings::can_hold() noexcept {
  dynamics_.update(state_.q, state_.v, Vector3::UnitZ());
  const Vector12 most = kLiftShare * share_.cwiseProduct(robot_.config().tau_max);
  return (hold(1.0).cwiseAbs() - most).maxCoeff() < 0.0;
}

Vector12 LegSprings::in_air() noexcept {
  dynamics_.update(state_.q, state_.v, Vector3::UnitZ());
  return hold(0.0);
}

double LegSprings::borne(const Vector12& measured) noexcept {
  const Vector12 in_air = this->in_air(), way = hold(1.0) - in_air;
  return way.dot(measured - in_air) / std::max(way.squaredNorm(), 1e-9);
}

Vector12 LegSprings::torques(const JointReference& reference, double load) noexcept {
  dynamics_.update(state_.q, state_.v, Vector3::UnitZ());
  Vector12 hold = this->hold(load);
  Vector12 pull = (reference.q - q_).cwiseMax(-kReach).cwiseMin(kReach);
  // Legs of a body that lies may be caught, also where the rear ones press and hold part of it up.
  const Vector12 freed = released_within_power(pull);
  pull = freed + smooth(load / kBears) * (pull - freed);
  // What slips off an obstacle must not be flung: that alone takes more power than the rise.
  for (int i = 0; i < kMotors; ++i) {
    const double ahead = std::copysign(1.0, pull[i]) * (dq_[i] - reference.dq[i]);
    pull[i] *= std::clamp(1.0 - (ahead - kRuns) / kLetGo, 0.0, 1.0);
  }
  Vector12 tau = hold + stiffness_ * pull + damping_ * reference.dq;
  const RobotConfig& config = robot_.config();
  for (int i = 0; i < kMotors; ++i) {
    const double share = kTorqueShare * share_[i], most = share * config.tau_max[i];
    tau[i] = within_motor_limits(config, i, tau[i], dq_[i], share);
    // Less power is nearer to it. Not by speed: a report that lies about that lets go of nothing.
    hold[i] = std::clamp(hold[i], -most, most);
  }
  const LimitedTorques out = limit_power(tau, hold, dq_, watts_, damping_);
  if (!out.exceeds || !hold.allFinite() || !dq_.allFinite()) return out.torques;
  const double braking = limit_power(hold - damping_ * dq_, hold, dq_, watts_).scale;
  // Against what the motors add by themselves: what they make is nearer to holding.
  const Vector12 against = hold + (1.0 - braking) * damping_ * dq_;
  return against.cwiseMax(-config.tau_max).cwiseMin(config.tau_max);
}

}  // namespace surefoot
