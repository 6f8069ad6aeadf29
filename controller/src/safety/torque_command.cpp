// SPDX-License-Identifier: BSD-3-Clause
#include "safety/torque_command.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "safety/holding_torques.hpp"
#include "safety/motor_limits.hpp"
#include "tasks/foot_loads.hpp"

namespace surefoot {

namespace {
constexpr double kUnlimited = std::numeric_limits<double>::infinity();
// [s] Time over which the damping of a lost leg fades in, so that the leg does not jerk. Chosen
// about equal to 21 ms, in which TorqueRateLimiter (9.5 % of tau_max in 2 ms) lets a torque fall
// from tau_max to 0. If larger: the leg sags. Test: tests/closed_loop/test_lost_leg.py.
constexpr double kFadeTime = 0.02;

// Round to a float towards zero: rounding up could exceed the torque limit.
float to_float_towards_zero(double x) noexcept {
  const float nearest = static_cast<float>(x);
  return std::abs(double{nearest}) > std::abs(x) ? std::nextafter(nearest, 0.0F) : nearest;
}

}  // namespace

Status TorqueCommand::set_torques(const Solution& solution, const Dynamics& dynamics,
                                  const RobotState& state, const Reference& reference,
                                  const Gains& gains) noexcept {
  Vector12 tau;
  for (int i = 0; i < kMotors; ++i) tau[i] = solution.torques[robot_.motor_to_v()[i] - 6];
  const bool limited = set_torques(tau, 0.0, dynamics, state, reference, gains);
  return limited ? Status::kSaturated : solution.status;
}

bool TorqueCommand::set_torques(const Vector12& tau, double damping, const Dynamics& dynamics,
                                const RobotState& state, const Reference& reference,
                                const Gains& gains) noexcept {
  damping_ = motor_damping_ + damping;
  lost_damping_ = gains.damping_kd;
  const Vector12 dq = joint_speeds(state);
  const auto limit_power_to = [&](const Eigen::Vector4d& contact, double watts) {
    const Eigen::Vector4d share = load_shares(gains, contact, reference);
    Vector12 hold = holding_torques(dynamics, robot_.mass(), state, share);
    // The power limit scales the torques towards the holding torques, so the holding torques must
    // be within the torque limits. The torque limits at zero speed are used, because a wrong speed
    // measurement must not take away the torques that hold the robot.
    for (int i = 0; i < kMotors; ++i) {
      const double limit = torque_share_[i] * robot_.config().tau_max[i];
      hold[i] = std::clamp(hold[i], -limit, limit);  // NaN stays NaN
    }
    limited_ = limit_swing_legs_first(tau, hold, dq, reference, watts);
    limit_at_present_speeds(hold, dq, reference, watts);
  };
  limit_power_to(state.contact, power_limit_);
  // If no scale satisfies the power limit, scale towards torques that hold the robot on all four
  // feet. A foot that is unloaded for a moment carries its share of the load again when the other
  // legs yield.
  if (limited_.no_scale_within_limit) limit_power_to(Eigen::Vector4d::Ones(), power_limit_);
  // If these holding torques alone exceed the power limit, do not scale the command: with too
  // little torque the robot would fall, and its motors would take several times as much power in
  // the fall. The power protection is then the only limit.
  if (limited_.no_scale_within_limit) limit_power_to(state.contact, kUnlimited);
  const bool any_leg_limited = limit_runaway_legs(dq, reference);
  if (limited_.scale == 1.0 && limited_.swing_scale == 1.0 && !any_leg_limited) return false;
  // The scaled torques contain holding torques, which may exceed the torque that a motor can
  // produce at its speed.
  for (int i = 0; i < kMotors; ++i) {
    double& torque = limited_.torques[i];
    torque = within_motor_limits(robot_.config(), i, torque, dq[i], torque_share_[i]);
  }
  return true;
}

// Limit the power of the swing legs if that is enough. Otherwise the swing legs get their holding
// torques, and the torques of the other legs are scaled too.
LimitedTorques TorqueCommand::limit_swing_legs_first(const Vector12& tau, const Vector12& hold,
                                                     const Vector12& dq, const Reference& reference,
                                                     double watts) const noexcept {
  Vector12 without_swing = tau;
  std::array<bool, kLegs> swings{};
  for (int leg = 0; leg < kLegs; ++leg) {
    swings[leg] = reference.stepping && !reference.feet[leg].stance;
    if (!swings[leg]) continue;
    const int first = kLegJoints * leg;
    without_swing.segment<kLegJoints>(first) = hold.segment<kLegJoints>(first);
  }
  LimitedTorques out = limit_power(tau, without_swing, dq, watts, damping_);
  std::swap(out.scale, out.swing_scale);
  out.swings = swings;
  if (!out.no_scale_within_limit) return out;
  // A leg that brakes may take more power with its holding torques. Then all legs are scaled.
  if (power_of(without_swing, dq, damping_) > power_of(tau, dq, damping_))
    return limit_power(tau, hold, dq, watts, damping_);
  out = limit_power(without_swing, hold, dq, watts, damping_);
  out.swing_scale = 0.0;
  out.swings = swings;
  return out;
}

// Limit the power at the present joint velocities too, if that is possible. `dq`, at which it is
// limited already, may be predicted over the delay, and a robot with limited torques, or after a
// push, does not move as predicted.
void TorqueCommand::limit_at_present_speeds(const Vector12& hold, const Vector12& dq,
                                            const Reference& reference, double watts) noexcept {
  if (limited_.no_scale_within_limit) return;
  const LimitedTorques more =
      limit_swing_legs_first(limited_.torques, hold, present_speeds_, reference, watts);
  if (more.no_scale_within_limit || (more.scale == 1.0 && more.swing_scale == 1.0)) return;
  const auto swing_scale = [](const LimitedTorques& limited, bool swings) {
    return swings ? limited.swing_scale : limited.scale;
  };
  for (int leg = 0; leg < kLegs; ++leg) {
    if (!limited_.swings[leg] && !more.swings[leg]) continue;
    limited_.swing_scale =
        swing_scale(limited_, limited_.swings[leg]) * swing_scale(more, more.swings[leg]);
    break;  // the legs that swing are the same in both
  }
  for (int leg = 0; leg < kLegs; ++leg) limited_.swings[leg] |= more.swings[leg];
  limited_.scale *= more.scale;
  limited_.torques = more.torques;
  limited_.power = power_of(limited_.torques, dq, damping_);
}

Vector12 TorqueCommand::joint_speeds(const RobotState& state) const noexcept {
  Vector12 dq;
  for (int i = 0; i < kMotors; ++i) dq[i] = state.v[robot_.motor_to_v()[i]];
  return dq;
}

// Limit the torques of runaway legs, even to less than the holding torques: the power of one leg
// may rise by at most a quarter of the power limit. The rise is extrapolated from the estimated
// joint velocities of this sample. `dq` may be predicted over the delay, and is used only for the
// damping torques and limited_.power. A leg that the reference swings is meant to accelerate, so it
// is no runaway leg. Return whether a leg was limited.
bool TorqueCommand::limit_runaway_legs(const Vector12& dq, const Reference& reference) noexcept {
  const double share = power_limit_ / kLegs;
  const Vector12 total_torque = limited_.torques - damping_ * dq;
  bool any_leg_limited = false;
  for (int leg = 0; leg < kLegs; ++leg) {
    const double power_rise = runaway_legs_.power_rise(total_torque, leg);
    const bool swings = reference.stepping && !reference.feet[leg].stance;
    if (leg == lost_leg_ || swings || !(power_rise > share)) continue;
    limited_.torques.segment<kLegJoints>(kLegJoints * leg) *= share / power_rise;
    any_leg_limited = true;
  }
  if (any_leg_limited) limited_.power = power_of(limited_.torques, dq, damping_);
  return any_leg_limited;
}

// All motors of a lost leg damp, not only the failed motors, so that the leg moves little.
LowCmd TorqueCommand::command(double dt) noexcept {
  Vector12 tau = limited_.torques, kd = Vector12::Constant(damping_);
  if (lost_leg_ >= 0) {
    tau.segment<kLegJoints>(kLegJoints * lost_leg_).setZero();
    lost_damping_share_ = std::min(lost_damping_share_ + dt / kFadeTime, 1.0);
    kd.segment<kLegJoints>(kLegJoints * lost_leg_).setConstant(lost_damping_share_ * lost_damping_);
  }
  return torque_low_cmd(tau, kd);
}

LowCmd torque_low_cmd(const Vector12& torques, const Vector12& kd) noexcept {
  LowCmd command = init_low_cmd();
  for (int i = 0; i < kMotors; ++i) {
    MotorCmd& motor = command.motorCmd[i];
    motor.tau = to_float_towards_zero(torques[i]);
    if (kd[i] > 0.0) {
      motor.dq = 0.0F;
      motor.Kd = static_cast<float>(kd[i]);
    }
  }
  return command;
}

}  // namespace surefoot
