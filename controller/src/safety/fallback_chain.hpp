// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dynamics/dynamics.hpp"
#include "surefoot/fallback_level.hpp"
#include "surefoot/gains.hpp"
#include "surefoot/types.hpp"
#include "tasks/body_acceleration.hpp"

namespace surefoot {

/// Contact forces [N], world axes, one column per foot, and the contact wrench for which they were
/// planned.
struct PlannedForces {
  FeetMatrix forces = FeetMatrix::Zero();
  FeetWrench wrench{Vector3::Zero(), Vector3::Zero()};
};

/// The levels of the fallback chain that need no QP. They compute torques from the present state
/// after both solves of the QP have failed, the usual solve and the cold solve.
///
/// These levels ignore custom tasks. CommandHold limits the time for which their commands may act.
/// Real-time: yes.
class FallbackChain {
 public:
  explicit FallbackChain(const Robot& robot)
      : robot_(robot), unloaded_state_(robot.nq(), robot.nv()) {}

  /// Store the contact forces of a solved tick, and the contact wrench that the body tasks of that
  /// tick required.
  void remember(const Gains& gains, const Dynamics& dynamics, const RobotState& state,
                const Reference& reference, const FeetMatrix& forces) noexcept;

  /// Compute the torques of the first level, in this order, that gives twelve finite torques:
  ///   kForces:     tau = h_leg - J_leg^T f, where f are the forces of the last solution plus the
  ///                change of the desired wrench since then, shared by add_wrench(). So torques
  ///                do not jump while constraints are active. Without a last solution, f
  ///                produces the whole desired wrench.
  ///   kLastForces: the same, where f are the forces of the last solution
  ///   kGravity:    holding_torques() of a robot without payload; the motors damp too
  /// @return the level, or kHold if no level gives finite torques
  FallbackLevel compute_fallback(const Gains& gains, const Dynamics& dynamics,
                                 const RobotState& state, const Reference& reference) noexcept;

  /// Torques of the level that was found last [N.m], SDK motor order, within the motor limits.
  const Vector12& torques() const noexcept { return torques_; }
  /// Motor-side damping [N.m.s/rad] to be added to these torques.
  double damping() const noexcept { return damping_; }

  /// See WholeBodyController::set_torque_share().
  void set_torque_share(const Vector12& share) noexcept { torque_share_ = share; }
  /// Discard the last solution.
  void reset() noexcept { has_last_solution_ = false; }

 private:
  bool try_forces(const Dynamics& dynamics, const RobotState& state,
                  const FeetMatrix& forces) noexcept;
  bool try_torques(const Vector12& torques, const RobotState& state) noexcept;

  Robot robot_;
  RobotState unloaded_state_;  // state without external wrench
  PlannedForces last_solution_;
  bool has_last_solution_ = false;
  Vector12 torque_share_ = Vector12::Ones();
  Vector12 torques_ = Vector12::Zero();
  double damping_ = 0.0;
};

/// Friction cones and largest normal forces of the feet, FR FL RR RL.
struct ForceCones {
  Vector3 normal;              ///< unit ground normal, upwards, world axes
  Eigen::Vector4d friction;    ///< friction coefficients
  Eigen::Vector4d normal_max;  ///< [N]
};

/// Change contact forces so that their wrench about the centre of mass changes by `wrench_change`.
/// The changes df_i of the forces are as small as possible, weighted with the shares:
///   minimise    sum |df_i|^2 / share_i
///   subject to  sum df_i = force,  sum (p_i - p_com) x df_i = moment   of wrench_change
/// Then each force is clamped to its cone. Nine more iterations distribute the part of the wrench
/// that clamping has removed. Real-time: yes.
/// @param forces contact forces to change, world axes [N]
/// @param share share of its even load that each foot may carry, 0 .. 1, FR FL RR RL
/// @return forces + df, clamped, world axes [N]
FeetMatrix add_wrench(const Dynamics& dynamics, const FeetMatrix& forces,
                      const FeetWrench& wrench_change, const Eigen::Vector4d& share,
                      const ForceCones& cones) noexcept;

}  // namespace surefoot
