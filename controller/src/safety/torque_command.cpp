// SPDX-License-Identifier: BSD-3-Clause
#include "safety/torque_command.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "safety/holding_torques.hpp"
#include "safety/motor_limits.hpp"
#include "wbc/limits.hpp"

namespace surefoot {

namespace {
constexpr double kUnlimited = std::numeric_limits<double>::infinity();
constexpr double kFadeTime = 0.02;  // [s] of a lost leg's damping: a moving leg gets no jolt

// The float next to it towards zero: a limit that is rounded up is exceeded.
float towards_zero(double x) noexcept {
  const float nearest = static_cast<float>(x);
  return std::abs(double{nearest}) > std::abs(x) ? std::nextafter(nearest, 0.0F) : nearest;
}

}  // namespace

Status TorqueCommand::take(const Solution& solution, const Dynamics& dynamics,
                           const RobotState& state, const Reference& reference,
                           const Gains& gains) noexcept {
  Vector12 tau;
  for (int i = 0; i < kMotors; ++i) tau[i] = solution.torques[robot_.motor_to_v()[i] - 6];
  const bool limited = take(tau, 0.0, dynamics, state, reference, gains);
  return limited ? Status::kSaturated : solution.status;
}

bool TorqueCommand::take(const Vector12& tau, double damping, const Dynamics& dynamics,
                         const RobotState& state, const Reference& reference,
                         const Gains& gains) noexcept {
  damping_ = options_.motor_damping + damping;
  lost_damping_ = gains.damping_kd;
  const Vector12 dq = speeds(state);
  const auto limit_to = [&](const Eigen::Vector4d& contact, double watts) {
    const Eigen::Vector4d share = load_shares(gains, contact, reference);
    Vector12 hold = holding_torques(dynamics, robot_.mass(), state, share);
    // Less power is nearer to it, and must not be more torque than the motors have. Not by speed:
    // a report that lies about that lets go of nothing.
    for (int i = 0; i < kMotors; ++i) {
      const double limit = torque_share_[i] * robot_.config().tau_max[i];
      hold[i] = std::clamp(hold[i], -limit, limit);  // what is no number stays none
    }
    limited_ = limit_power(tau, hold, dq, watts, damping_);
  };
  limit_to(state.contact, options_.power_limit);
  // A foot that is light for a moment bears its share again when the others yield.
  if (limited_.exceeds) limit_to(Eigen::Vector4d::Ones(), options_.power_limit);
  // Holding alone takes more than the limit: a robot let go of now falls, and takes several times
  // the power on its way. The command goes as it is; the protection is there for the rest.
  if (limited_.exceeds) limit_to(state.contact, kUnlimited);
  const bool flung = limit_flung_legs(dq);
  if (limited_.scale == 1.0 && !flung) return false;
  // What was mixed in may be more than a motor has left at its speed.
  for (int i = 0; i < kMotors; ++i) {
    double& torque = limited_.torques[i];
    torque = within_motor_limits(robot_.config(), i, torque, dq[i], torque_share_[i]);
  }
  return true;
}

Vector12 TorqueCommand::speeds(const RobotState& state) const noexcept {
  Vector12 dq;
  for (int i = 0; i < kMotors; ++i) dq[i] = state.v[robot_.motor_to_v()[i]];
  return dq;
}

// The last word, whatever holding takes: none alone may gain more than its share of the power.
// By the speeds measured, with a delay too, for it is what they were that tells. @return did any?
bool TorqueCommand::limit_flung_legs(const Vector12& dq) noexcept {
  const double share = options_.power_limit / kLegs;
  const Vector12 made = limited_.torques - damping_ * dq;
  bool flung = false;
  for (int leg = 0; leg < kLegs; ++leg) {
    const double rise = flung_.rise(made, leg);
    if (leg == lost_leg_ || !(rise > share)) continue;
    limited_.torques.segment<kLegJoints>(kLegJoints * leg) *= share / rise;
    flung = true;
  }
  if (flung) limited_.power = power_of(limited_.torques, dq, damping_);
  return flung;
}

// What is left of the leg moves as little as it can, whichever of its motors is the dead one.
LowCmd TorqueCommand::command(double dt) noexcept {
  Vector12 tau = limited_.torques, kd = Vector12::Constant(damping_);
  if (lost_leg_ >= 0) {
    tau.segment<kLegJoints>(kLegJoints * lost_leg_).setZero();
    faded_in_ = std::min(faded_in_ + dt / kFadeTime, 1.0);
    kd.segment<kLegJoints>(kLegJoints * lost_leg_).setConstant(faded_in_ * lost_damping_);
  }
  return torque_low_cmd(tau, kd);
}

LowCmd torque_low_cmd(const Vector12& torques, const Vector12& kd) noexcept {
  LowCmd command = init_low_cmd();
  for (int i = 0; i < kMotors; ++i) {
    MotorCmd& motor = command.motorCmd[i];
    motor.tau = towards_zero(torques[i]);
    if (kd[i] > 0.0) {
      motor.dq = 0.0F;
      motor.Kd = static_cast<float>(kd[i]);
    }
  }
  return command;
}

}  // namespace surefoot
