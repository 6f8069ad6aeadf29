// SPDX-License-Identifier: BSD-3-Clause
#include "safety/fallback_chain.hpp"

#include <algorithm>

#include "safety/holding_torques.hpp"
#include "safety/motor_limits.hpp"
#include "tasks/even_forces.hpp"
#include "tasks/foot_loads.hpp"

namespace surefoot {

namespace {

// Number of iterations of add_wrench(). The first iteration distributes the change of the wrench.
// Each further iteration distributes the part of the wrench that clamping has removed. Chosen. If
// smaller: not enough for feet at their friction cones. If larger: too slow for a tick.
constexpr int kShareIterations = 10;

Vector3 clamp_to_cone(const Vector3& force, const Vector3& normal, double friction,
                      double normal_max) noexcept {
  const double normal_force = force.dot(normal);
  const double clamped_normal = std::clamp(normal_force, 0.0, normal_max);
  const Vector3 tangential = force - normal_force * normal;
  const double tangential_norm = tangential.norm(), max_tangential = friction * clamped_normal;
  return clamped_normal * normal +
         (tangential_norm > max_tangential ? max_tangential / tangential_norm : 1.0) * tangential;
}

FeetWrench desired_wrench(double mass, const Gains& gains, const Dynamics& dynamics,
                          const RobotState& state, const Reference& reference) noexcept {
  const BodyAcceleration demand = body_acceleration(gains, mass, dynamics, state, reference);
  return feet_wrench(demand, mass, dynamics, state);
}

// Return the share of its even load that each foot carries in the level kGravity: all feet in a
// stand. While feet step, the feet that are planned to carry load. In a flight, when no foot is,
// all feet land.
Eigen::Vector4d supporting_feet(const Reference& reference) noexcept {
  Eigen::Vector4d shares = Eigen::Vector4d::Ones();
  if (!reference.stepping) return shares;
  for (int leg = 0; leg < kLegs; ++leg) shares[leg] = planned_load(reference.feet[leg]);
  return shares.sum() > 0.0 ? shares : Eigen::Vector4d::Ones();
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

FeetMatrix add_wrench(const Dynamics& dynamics, const FeetMatrix& forces,
                      const FeetWrench& wrench_change, const Eigen::Vector4d& share,
                      const ForceCones& cones) noexcept {
  const FeetWrench initial_wrench = wrench_of(dynamics, forces);
  const FeetWrench desired{initial_wrench.force + wrench_change.force,
                           initial_wrench.moment + wrench_change.moment};
  FeetMatrix out = forces;
  for (int k = 0; k < kShareIterations; ++k) {
    const FeetWrench current = wrench_of(dynamics, out);
    const Vector12 change = even_forces(dynamics, desired.force - current.force,
                                        desired.moment - current.moment, share);
    for (int leg = 0; leg < kLegs; ++leg) {
      out.col(leg) = clamp_to_cone(out.col(leg) + change.segment<3>(3 * leg), cones.normal,
                                   cones.friction[leg], cones.normal_max[leg]);
    }
  }
  return out;
}

void FallbackChain::remember(const Gains& gains, const Dynamics& dynamics, const RobotState& state,
                             const Reference& reference, const FeetMatrix& forces) noexcept {
  last_solution_ = {forces, desired_wrench(robot_.mass(), gains, dynamics, state, reference)};
  has_last_solution_ = true;
}

FallbackLevel FallbackChain::compute_fallback(const Gains& gains, const Dynamics& dynamics,
                                              const RobotState& state,
                                              const Reference& reference) noexcept {
  const double mass = robot_.mass();
  const PlannedForces start = has_last_solution_ ? last_solution_ : PlannedForces();
  const FeetWrench desired = desired_wrench(mass, gains, dynamics, state, reference);
  const FeetWrench wrench_change{desired.force - start.wrench.force,
                                 desired.moment - start.wrench.moment};
  const ForceCones cones{reference.ground_normal, robot_.config().friction * state.friction,
                         normal_force_limits(gains, mass * kGravity, state.contact, reference)};
  const Eigen::Vector4d share = load_shares(gains, state.contact, reference);
  damping_ = 0.0;
  if (try_forces(dynamics, state,
                 add_wrench(dynamics, start.forces, wrench_change, share, cones))) {
    return FallbackLevel::kForces;
  }
  if (has_last_solution_ && try_forces(dynamics, state, last_solution_.forces))
    return FallbackLevel::kLastForces;
  if (!try_torques(holding_torques(dynamics, mass, unloaded_state_, supporting_feet(reference)),
                   state)) {
    return FallbackLevel::kHold;
  }
  damping_ = gains.damping_kd;
  return FallbackLevel::kGravity;
}

bool FallbackChain::try_forces(const Dynamics& dynamics, const RobotState& state,
                               const FeetMatrix& forces) noexcept {
  Vector12 torques;
  for (int leg = 0; leg < kLegs; ++leg) {
    const LegDynamics& leg_dynamics = dynamics.legs()[leg];
    torques.segment<3>(3 * leg) =
        leg_dynamics.h_leg - leg_dynamics.J_leg.transpose() * forces.col(leg);
  }
  return try_torques(torques, state);
}

// Clip the torques to the motor limits and store them, if all twelve are finite. Otherwise reject
// all twelve, because a part of the torques alone would push the robot over.
bool FallbackChain::try_torques(const Vector12& torques, const RobotState& state) noexcept {
  const RobotConfig& config = robot_.config();
  Vector12 clipped;
  for (int i = 0; i < kMotors; ++i) {
    const double dq = state.v[robot_.motor_to_v()[i]];
    clipped[i] = within_motor_limits(config, i, torques[i], dq, torque_share_[i]);
  }
  // Clipping makes infinite torques finite, so the torques before clipping are checked too. The
  // comparison below is false for NaN.
  if (!torques.allFinite() || !(clipped.array().abs() <= config.tau_max.array()).all()) {
    return false;
  }
  torques_ = clipped;
  return true;
}

const char* to_string(FallbackLevel fallback_level) noexcept {
  constexpr const char* names[kFallbackLevels] = {"solved",  "cold_solve", "forces", "last_forces",
                                                  "gravity", "hold",       "damping"};
  return names[static_cast<int>(fallback_level)];
}

}  // namespace surefoot
