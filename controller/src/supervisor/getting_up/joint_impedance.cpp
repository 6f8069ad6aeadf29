// SPDX-License-Identifier: BSD-3-Clause
#include "supervisor/getting_up/joint_impedance.hpp"

#include <algorithm>
#include <cmath>

#include "safety/holding_torques.hpp"
#include "safety/motor_limits.hpp"
#include "safety/power_limiter.hpp"
#include "supervisor/common/motor_measurements.hpp"
#include "supervisor/common/smoothstep.hpp"

namespace surefoot {

namespace {
// The constants are chosen by hand, so that the power protection does not trip. Measured with these
// values: at most 93 W at level 1 (100 W) in benchmarks/get_up.py; no trip in
// benchmarks/false_trips.py. Tests: test_joint_impedance.cpp.
//
// [rad] Largest deflection of a spring. Must exceed kMaxLead of LegFolding (0.4). The larger this
// deflection, the more power a leg takes when it comes free from an obstacle.
constexpr double kMaxDeflection = 0.45;
// Largest commanded torque, as a share of tau_max; the rest is a margin.
constexpr double kTorqueShare = 0.9;
// can_hold() requires holding torques below this share of tau_max; the rest is for raising the
// body. It does not limit commanded torques.
constexpr double kMaxHoldingShare = 0.75;
// [rad/s] The spring of a joint is weakened if the joint moves faster than its reference, in the
// direction of the spring torque, by more than kFreeLegSpeed. The spring torque is zero from
// kFreeLegSpeed + kFreeLegSpeedRange on. kFreeLegSpeed is larger than the velocity errors of normal
// tracking. The sum is smaller than 9 rad/s, which legs reach when they come free.
constexpr double kFreeLegSpeed = 2.0;
constexpr double kFreeLegSpeedRange = 2.0;
// [rad/s] Angular speed of the body. Between these two values, the damping falls linearly from full
// to kMinDampingShare; above, it stays at kMinDampingShare. Larger than the angular speed while
// legs fold. Smaller than 3 rad/s, at which bodies tip over a leg.
constexpr double kFallRateStart = 0.6;
constexpr double kFallRateEnd = 1.6;
// Smallest damping, as a share of the damping D of RisePlan. Above 0, because damping absorbs the
// energy of a falling body.
constexpr double kMinDampingShare = 0.25;
// [s] Time constant with which the damping changes: ten periods at 500 Hz, so that torques do not
// jump.
constexpr double kDampingFilterTime = 0.02;
// [m g] Planned load on the legs from which no leg can be caught on something. Below this load,
// limit_power_when_free() also limits the springs; it acts fully at load 0.
constexpr double kLoadedShare = 0.1;
}  // namespace

JointImpedance::JointImpedance(const Robot& robot, const RisePlan& plan, double watts)
    : robot_(robot),
      dynamics_(robot),
      state_(robot.nq(), robot.nv()),
      stiffness_(plan.stiffness),
      full_damping_(plan.damping),
      damping_(plan.damping),
      power_limit_(watts) {
  R_base_imu_ = quaternion_wxyz(robot.config().quat_base_imu);
}

void JointImpedance::read(const LowState& state) noexcept {
  dq_ = measured_velocities(state);
  for (int i = 0; i < kMotors; ++i) {
    q_[i] = state.motorState[i].q;
    state_.q[robot_.motor_to_q()[i]] = q_[i];
  }
  const std::array<float, 4> imu = state.imu.quaternion;  // the field is packed, so it is copied
  const Quaternion R_world_imu(imu[0], imu[1], imu[2], imu[3]);
  R_world_base_ = (R_world_imu * R_base_imu_.conjugate()).normalized();
  state_.q.segment<4>(3) = R_world_base_.coeffs();
}

void JointImpedance::reduce_damping(double angular_speed, double dt) noexcept {
  const double reduction =
      std::clamp((angular_speed - kFallRateStart) / (kFallRateEnd - kFallRateStart), 0.0, 1.0);
  const double desired = (1.0 - (1.0 - kMinDampingShare) * reduction) * full_damping_;
  damping_ += dt / (dt + kDampingFilterTime) * (desired - damping_);
}

// When a caught leg comes free, a spring of torque tau takes the power (tau - D dq) dq. This power
// is largest at dq = tau / (2 D), where it is tau^2 / (4 D). The sum over all springs must stay
// within the limit. Power grows with the square of the deflection, so the deflections are scaled by
// the square root of the ratio. The 1e-9 [W] avoid a division by zero.
Vector12 JointImpedance::limit_power_when_free(const Vector12& deflection) const noexcept {
  const double power_when_free = (stiffness_ * deflection).squaredNorm() / (4.0 * damping_);
  return deflection * std::sqrt(std::min(1.0, power_limit_ / std::max(power_when_free, 1e-9)));
}

// Return the torques that hold the legs and the share `load` of the robot's weight [N.m].
// dynamics_.update() must have been called for the present pose. holding_torques() subtracts
// f_sustained from the weight, so an upward force of (1 - load) m g leaves the share `load`.
Vector12 JointImpedance::gravity_torques(double load) noexcept {
  state_.f_sustained = (1.0 - load) * robot_.mass() * kGravity * Vector3::UnitZ();
  return holding_torques(dynamics_, robot_.mass(), state_, Eigen::Vector4d::Ones());
}

bool JointImpedance::can_hold() noexcept {
  dynamics_.update(state_.q, state_.v, Vector3::UnitZ());
  const Vector12 max_torque =
      kMaxHoldingShare * torque_share_.cwiseProduct(robot_.config().tau_max);
  return (gravity_torques(1.0).cwiseAbs() - max_torque).maxCoeff() < 0.0;
}

Vector12 JointImpedance::leg_gravity_torques() noexcept {
  dynamics_.update(state_.q, state_.v, Vector3::UnitZ());
  return gravity_torques(0.0);
}

double JointImpedance::load_share(const Vector12& measured) noexcept {
  const Vector12 leg_gravity_torques = this->leg_gravity_torques(),
                 direction = gravity_torques(1.0) - leg_gravity_torques;
  return direction.dot(measured - leg_gravity_torques) / std::max(direction.squaredNorm(), 1e-9);
}

Vector12 JointImpedance::torques(const JointReference& reference, double load) noexcept {
  dynamics_.update(state_.q, state_.v, Vector3::UnitZ());
  Vector12 hold = gravity_torques(load);
  Vector12 deflection = (reference.q - q_).cwiseMax(-kMaxDeflection).cwiseMin(kMaxDeflection);
  // The legs of a lying body may be caught on something. So the power that their springs take when
  // they come free is limited. `load` is 0 while the body lies, also while RearPressCheck presses
  // the rear legs on the ground.
  const Vector12 limited_deflection = limit_power_when_free(deflection);
  deflection =
      limited_deflection + smoothstep(load / kLoadedShare) * (deflection - limited_deflection);
  // Weaken the spring of a leg that slips off an obstacle. Otherwise this leg alone would take more
  // power than all legs take in a rise.
  for (int i = 0; i < kMotors; ++i) {
    const double speed_ahead = std::copysign(1.0, deflection[i]) * (dq_[i] - reference.dq[i]);
    deflection[i] *= std::clamp(1.0 - (speed_ahead - kFreeLegSpeed) / kFreeLegSpeedRange, 0.0, 1.0);
  }
  Vector12 tau = hold + stiffness_ * deflection + damping_ * reference.dq;
  const RobotConfig& config = robot_.config();
  for (int i = 0; i < kMotors; ++i) {
    const double share = kTorqueShare * torque_share_[i], max_torque = share * config.tau_max[i];
    tau[i] = within_motor_limits(config, i, tau[i], dq_[i], share);
    // limit_power() scales torques towards `hold`. The limit of `hold` does not depend on the
    // velocity, so that a wrong velocity in one sample does not drop the robot.
    hold[i] = std::clamp(hold[i], -max_torque, max_torque);
  }
  const LimitedTorques out = limit_power(tau, hold, dq_, power_limit_, damping_);
  // Usual case: some scale from 0 to 1 satisfies the power limit, and limit_power() has applied it.
  if (!out.no_scale_within_limit || !hold.allFinite() || !dq_.allFinite()) return out.torques;
  // Otherwise the damping takes too much power, whatever the scale. kept_damping_share is the share
  // of the damping whose power, together with that of the holding torques, is within the limit.
  const double kept_damping_share =
      limit_power(hold - damping_ * dq_, hold, dq_, power_limit_).scale;
  // Counteract the rest of the damping, which the motors add by themselves.
  const Vector12 counter_torque = hold + (1.0 - kept_damping_share) * damping_ * dq_;
  return counter_torque.cwiseMax(-config.tau_max).cwiseMin(config.tau_max);
}

}  // namespace surefoot
