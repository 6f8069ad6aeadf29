// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "surefoot/qp_problem.hpp"
#include "surefoot/robot.hpp"
#include "surefoot/task.hpp"
#include "surefoot/types.hpp"

namespace surefoot {

class Dynamics;

/// Options of a WholeBodyController: fixed at construction, unlike gains.
struct WholeBodyOptions {
  QpForm form = QpForm::kAuto;  ///< form of the QP
  double tolerance = 1e-6;      ///< of the QP residuals, in the scaling of the QP; 1e-14 .. 1e-3

  /// Throw surefoot::Error if an option is out of range; the message names it.
  void validate() const;
};

/// Whole-body controller for users with their own estimator or planner: RobotState and Reference
/// in, joint torques out.
///
/// Each tick solves one QP. Cost: errors in the desired accelerations of the body (centre of mass
/// or base, orientation, angular momentum), of the posture and of custom tasks, and the distance of
/// the contact forces from the even forces. Equality constraints: rigid-body dynamics with
/// armature, and the desired accelerations of the contact points. One exception: in the general
/// form, the foot row of a nearly singular leg is part of the cost. Near the support edge an
/// unloaded leg is released: its joint limits are applied after the QP. Hard constraints: friction
/// and largest normal force of each foot, which always allow f = 0. Elastic constraints with exact
/// penalties: motor torque by the torque-speed curve, joint position and velocity, and hold-down;
/// so the QP is always feasible. Finally the torques are clipped to the motor limits;
/// Solution::clipped_torque reports by how much. docs/condensed-qp.md has the equations.
///
/// Assumes spherical feet that roll, and one ground normal for all feet. Not thread-safe.
class WholeBodyController {
 public:
  /// Throws surefoot::Error if the robot does not fit the form of the QP, if a leg is singular in
  /// its standing pose, or if a gain or an option is invalid.
  explicit WholeBodyController(const Robot& robot);
  WholeBodyController(const Robot& robot, const Gains& gains, const WholeBodyOptions& options = {});
  ~WholeBodyController();
  WholeBodyController(WholeBodyController&&) noexcept;

  /// Compute one tick. Never throws. Real-time: yes, if the custom tasks are.
  /// @param state q (nq,) and v (nv,) in Pinocchio's order; contact confidence 0 .. 1 per foot
  /// @param reference in the world frame of `state`
  /// @return the solution, see Solution for the fields that are valid at each status
  const Solution& update(const RobotState& state, const Reference& reference) noexcept;

  /// Return the reference that keeps the robot in its present pose: centre of mass, base pose,
  /// contact points and posture of `state`, at rest. Throws surefoot::Error if q or v has the wrong
  /// size, a value is not finite or out of range, or the quaternion is not of unit length.
  /// Real-time: no.
  Reference hold(const RobotState& state);

  /// Compute one tick with dynamics that are already computed; StandController uses this.
  /// Real-time: yes, if the custom tasks are.
  /// @param dynamics computed at `state` and at the ground normal of `reference`
  const Solution& solve(const Dynamics& dynamics, const RobotState& state,
                        const Reference& reference) noexcept;

  /// Solve the QP of the last solve() or update() again after kMaxIterations or kInfeasible: from a
  /// cold start, in one attempt of ProxQP, with ten times the tolerance. After any other status
  /// nothing happens. Custom tasks are not called again. Real-time: yes.
  /// @param dynamics the dynamics that were passed to that solve()
  const Solution& solve_cold(const Dynamics& dynamics) noexcept;

  /// Add a custom task, in force from the next tick on. Throws surefoot::Error if `task` is null or
  /// its rows() is not 1 .. 1000. Real-time: no.
  void add_task(std::shared_ptr<Task> task);

  const Solution& solution() const noexcept;  ///< solution of the last tick
  /// QP that the last tick solved, in its scaling: the hard QP, or the elastic one with slacks
  /// while a constraint is violated. For benchmarks and debugging. Real-time: yes.
  const QpProblem& qp() const noexcept;
  const Gains& gains() const noexcept;

  /// Set the gains, between ticks. Throws surefoot::Error and changes nothing if a gain is invalid.
  void set_gains(const Gains& gains);
  /// Set the gains within a tick. Real-time: yes.
  /// @return false if a gain is invalid; nothing changes then
  bool adopt_gains(const Gains& gains) noexcept;

  /// Set the share of its torque limit that each motor may use, 0 .. 1, SDK motor order; less for a
  /// hot motor, for example. The call is ignored if a value is outside [0, 1]. Real-time: yes.
  void set_torque_share(const Vector12& share) noexcept;
  const Vector12& torque_share() const noexcept;

  /// Discard the warm start and the last contact forces; Solution::status becomes kWaiting.
  /// Real-time: yes.
  void reset() noexcept;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace surefoot
