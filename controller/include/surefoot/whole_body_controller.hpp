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
  double tolerance = 1e-6;      ///< tolerance of the residuals of the scaled QP, 1e-14 .. 1e-3

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
/// form, the desired acceleration of the foot of a nearly singular leg is a cost, not a constraint.
/// Near the support edge, the QP widens the joint limits of an unloaded leg so far that they have
/// no effect; the limits are then applied to its solution. Hard constraints: friction and largest
/// normal force of each foot, which always allow f = 0. Elastic constraints with exact penalties:
/// motor torque (torque-speed curve), joint position and velocity, and hold-down. Because these
/// constraints are elastic, the QP is always feasible. Finally the torques are clipped to the motor
/// limits; Solution::clipped_torque is the largest amount clipped.
/// docs/explanation/condensed-qp.md has the equations.
///
/// Assumes spherical feet that roll, and one ground normal for all feet. Not thread-safe.
class WholeBodyController {
 public:
  /// Create a controller with RobotConfig::gains and default options. Throws surefoot::Error if the
  /// robot does not fit the form of the QP, if a leg is singular in its standing pose, or if a gain
  /// or an option is invalid.
  explicit WholeBodyController(const Robot& robot);
  /// The same with other gains than RobotConfig::gains.
  WholeBodyController(const Robot& robot, const Gains& gains, const WholeBodyOptions& options = {});
  ~WholeBodyController();
  /// Take over the content of another WholeBodyController, which may only be destroyed afterwards.
  WholeBodyController(WholeBodyController&&) noexcept;

  /// Compute one tick. Never throws. Real-time: yes, if the custom tasks are.
  /// @param state q (nq,) and v (nv,) in Pinocchio's order; contact confidence 0 .. 1 per foot
  /// @param reference desired motion, in the world frame of `state`
  /// @return the solution, see Solution for the fields that are valid at each status
  const Solution& update(const RobotState& state, const Reference& reference) noexcept;

  /// Return a reference that keeps the robot in its present pose: centre of mass, base pose,
  /// contact points and posture of `state`, and zero velocities. Throws surefoot::Error if q or v
  /// has the wrong size, a value is not finite or out of range, or the quaternion is not of unit
  /// length. Real-time: no.
  Reference hold(const RobotState& state);

  /// Compute one tick with dynamics that are already computed; StandController uses this.
  /// Real-time: yes, if the custom tasks are.
  /// @param dynamics dynamics at `state` and at the ground normal of `reference`
  /// @param state as for update()
  /// @param reference as for update()
  /// @return the solution, as for update()
  const Solution& solve(const Dynamics& dynamics, const RobotState& state,
                        const Reference& reference) noexcept;

  /// Solve the QP of the last solve() or update() again after kMaxIterations or kInfeasible: from a
  /// cold start, in one attempt of ProxQP, with ten times the tolerance. After any other status
  /// nothing happens. Custom tasks are not called again. Real-time: yes.
  /// @param dynamics dynamics that were passed to that solve()
  /// @return the solution of the cold solve, or the unchanged solution if nothing happened
  const Solution& solve_cold(const Dynamics& dynamics) noexcept;

  /// Add a custom task, in force from the next tick on. Throws surefoot::Error if `task` is null or
  /// its rows() is not 1 .. 1000. Real-time: no.
  void add_task(std::shared_ptr<Task> task);

  const Solution& solution() const noexcept;  ///< solution of the last tick
  /// Return the scaled QP that the last tick solved, for benchmarks and debugging. It has slack
  /// variables if an elastic constraint was violated in this tick or in one of the ten ticks
  /// before; else it has none. Real-time: yes.
  const QpProblem& qp() const noexcept;
  const Gains& gains() const noexcept;  ///< gains last set

  /// Set the gains, between ticks. Throws surefoot::Error and changes nothing if a gain is invalid.
  /// Real-time: no.
  void set_gains(const Gains& gains);
  /// Set the gains within a tick. Real-time: yes.
  /// @return false if a gain is invalid; nothing changes then
  bool adopt_gains(const Gains& gains) noexcept;

  /// Set the share of its torque limit that each motor may use, 0 .. 1, SDK motor order. A hot
  /// motor gets less, for example. The call is ignored if a value is outside [0, 1]. Real-time:
  /// yes.
  void set_torque_share(const Vector12& share) noexcept;
  const Vector12& torque_share() const noexcept;  ///< shares last set, initially 1

  /// Discard the warm start and the last contact forces; Solution::status becomes kWaiting.
  /// Real-time: yes.
  void reset() noexcept;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace surefoot
