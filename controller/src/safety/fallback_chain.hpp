// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dynamics/dynamics.hpp"
#include "surefoot/fallback_level.hpp"
#include "surefoot/gains.hpp"
#include "surefoot/types.hpp"
#include "tasks/body_acceleration.hpp"

namespace surefoot {

/// Contact forces [N] world axes, one column a foot, and the wrench that they were made for.
struct PlannedForces {
  FeetMatrix forces = FeetMatrix::Zero();
  FeetWrench wrench{Vector3::Zero(), Vector3::Zero()};
};

/// The rungs below the whole-body program: torques from today's state where no solve succeeded.
///
/// They know of the program only what it planned last, and nothing of tasks of the user's own. How
/// long they may act is CommandHold's business. Real-time: yes.
class FallbackChain {
 public:
  explicit FallbackChain(const Robot& robot)
      : robot_(robot), unloaded_state_(robot.nq(), robot.nv()) {}

  /// A tick was solved: note its forces, and the wrench that the body's tasks wanted.
  void remember(const Gains& gains, const Dynamics& dynamics, const RobotState& state,
                const Reference& reference, const FeetMatrix& forces) noexcept;

  /// Take the first of these rungs whose torques are numbers, all twelve:
  ///   kForces:     tau = h_leg - J_leg^T f; f as it was solved last, and what the body's tasks
  ///   want
  ///                more than then, as evenly as it can be shared. So torques do not jump where
  ///                limits are active. Where nothing was solved: f for all that the tasks want
  ///   kLastForces: the same, f as it was solved last
  ///   kGravity:    holding_torques() of a robot with nothing on its back; the motors damp too
  /// @return kHold where none has numbers
  FallbackLevel compute_fallback(const Gains& gains, const Dynamics& dynamics,
                                 const RobotState& state, const Reference& reference) noexcept;

  /// [N.m] SDK motor order, within the motors' limits; of the last rung that was found.
  const Vector12& torques() const noexcept { return torques_; }
  /// [N.m.s/rad] that the motors are to add by themselves.
  double damping() const noexcept { return damping_; }

  /// See WholeBodyController::set_torque_share().
  void set_torque_share(const Vector12& share) noexcept { torque_share_ = share; }
  /// Forget what was solved.
  void reset() noexcept { has_last_solution_ = false; }

 private:
  bool try_forces(const Dynamics& dynamics, const RobotState& state,
                  const FeetMatrix& forces) noexcept;
  bool try_torques(const Vector12& torques, const RobotState& state) noexcept;

  Robot robot_;
  RobotState unloaded_state_;  // comes from outside
  PlannedForces last_solution_;
  bool has_last_solution_ = false;  // is there a last?
  Vector12 torque_share_ = Vector12::Ones();
  Vector12 torques_ = Vector12::Zero();
  double damping_ = 0.0;
};

/// What each foot's force may be, FR FL RR RL.
struct ForceCones {
  Vector3 normal;              ///< unit, out of the ground, world axes
  Eigen::Vector4d friction;    ///< coefficients
  Eigen::Vector4d normal_max;  ///< [N]
};

/// Share more wrench (about the centre of mass) out among feet that bear forces already:
///   minimise sum |df_i|^2 / share_i   subject to   sum df_i = force,  sum (p_i - p_com) x df_i =
///   moment
/// clamped to the cones foot by foot; what that took is shared out again, nine times.
/// @param forces where it begins @param share how much of the load each foot may take, 0 .. 1
/// @return forces + df, [N] world axes. Real-time: yes.
FeetMatrix add_wrench(const Dynamics& dynamics, const FeetMatrix& forces,
                      const FeetWrench& wrench_change, const Eigen::Vector4d& share,
                      const ForceCones& cones) noexcept;

}  // namespace surefoot
