// SPDX-License-Identifier: BSD-3-Clause
#include "safety/command_ladder.hpp"

#include <algorithm>

#include "safety/holding_torques.hpp"
#include "safety/motor_limits.hpp"
#include "tasks/force_task.hpp"
#include "wbc/limits.hpp"

namespace surefoot {

namespace {

constexpr int kShares = 10;  // that a wrench is shared out: once, then what clamping took

Vector3 within_cone(const Vector3& force, const Vector3& normal, double friction,
                    double normal_max) noexcept {
  const double pressed = force.dot(normal);
  const double pressing = std::clamp(pressed, 0.0, normal_max);
  const Vector3 along = force - pressed * normal;
  const double slip = along.norm(), most = friction * pressing;
  return pressing * normal + (slip > most ? most / slip : 1.0) * along;
}

FeetWrench wanted_wrench(double mass, const Gains& gains, const Dynamics& dynamics,
                         const RobotState& state, const Reference& reference) noexcept {
  const BodyDemand demand = body_demand(gains, mass, dynamics, state, reference);
  return feet_wrench(demand, mass, dynamics, state);
}

FeetWrench wrench_of(const Dynamics& dynamics, const FeetMatrix& forces) noexcept {
  FeetWrench wrench{forces.rowwise().sum(), Vector3::Zero()};
  for (int leg = 0; leg < kLegs; ++leg) {
    const Vector3 arm = dynamics.legs()[leg].p_world_contact - dynamics.p_world_com();
    wrench.moment += arm.cross(forces.col(leg));
  }
  return wrench;
}

}  // namespace

FeetMatrix add_wrench(const Dynamics& dynamics, const FeetMatrix& forces, const FeetWrench& more,
                      const Eigen::Vector4d& share, const ForceCones& cones) noexcept {
  const FeetWrench before = wrench_of(dynamics, forces);
  const FeetWrench wanted{before.force + more.force, before.moment + more.moment};
  FeetMatrix out = forces;
  for (int k = 0; k < kShares; ++k) {
    const FeetWrench now = wrench_of(dynamics, out);
    const Vector12 change =
        even_forces(dynamics, wanted.force - now.force, wanted.moment - now.moment, share);
    for (int leg = 0; leg < kLegs; ++leg) {
      out.col(leg) = within_cone(out.col(leg) + change.segment<3>(3 * leg), cones.normal,
                                 cones.friction[leg], cones.normal_max[leg]);
    }
  }
  return out;
}

void CommandLadder::remember(const Gains& gains, const Dynamics& dynamics, const RobotState& state,
                             const Reference& reference, const FeetMatrix& forces) noexcept {
  last_ = {forces, wanted_wrench(robot_.mass(), gains, dynamics, state, reference)};
  known_ = true;
}

Rung CommandLadder::descend(const Gains& gains, const Dynamics& dynamics, const RobotState& state,
                            const Reference& reference) noexcept {
  const double mass = robot_.mass();
  const WantedForces start = known_ ? last_ : WantedForces();
  const FeetWrench wanted = wanted_wrench(mass, gains, dynamics, state, reference);
  const FeetWrench more{wanted.force - start.wrench.force, wanted.moment - start.wrench.moment};
  const ForceCones cones{reference.ground_normal, robot_.config().friction * state.friction,
                         normal_force_limits(gains, mass * kGravity, state.contact, reference)};
  const Eigen::Vector4d share = load_shares(gains, state.contact, reference);
  damping_ = 0.0;
  if (take_forces(dynamics, state, add_wrench(dynamics, start.forces, more, share, cones))) {
    return Rung::kForces;
  }
  if (known_ && take_forces(dynamics, state, last_.forces)) return Rung::kLastForces;
  if (!take(holding_torques(dynamics, mass, nothing_, Eigen::Vector4d::Ones()), state)) {
    return Rung::kHold;
  }
  damping_ = gains.damping_kd;
  return Rung::kGravity;
}

bool CommandLadder::take_forces(const Dynamics& dynamics, const RobotState& state,
                                const FeetMatrix& forces) noexcept {
  Vector12 torques;
  for (int leg = 0; leg < kLegs; ++leg) {
    const LegDynamics& one = dynamics.legs()[leg];
    torques.segment<3>(3 * leg) = one.h_leg - one.J_leg.transpose() * forces.col(leg);
  }
  return take(torques, state);
}

// All twelve, or none: a vector of parts that do not belong together pushes the robot over.
bool CommandLadder::take(const Vector12& torques, const RobotState& state) noexcept {
  const RobotConfig& config = robot_.config();
  Vector12 clipped;
  for (int i = 0; i < kMotors; ++i) {
    const double dq = state.v[robot_.motor_to_v()[i]];
    clipped[i] = within_motor_limits(config, i, torques[i], dq, torque_share_[i]);
  }
  // False of NaN too; an infinity was no torque either, whatever clipping makes of it.
  if (!torques.allFinite() || !(clipped.array().abs() <= config.tau_max.array()).all()) {
    return false;
  }
  torques_ = clipped;
  return true;
}

const char* to_string(Rung rung) noexcept {
  constexpr const char* names[kRungs] = {"solved",  "cold_solve", "forces", "last_forces",
                                         "gravity", "hold",       "damping"};
  return names[static_cast<int>(rung)];
}

}  // namespace surefoot
