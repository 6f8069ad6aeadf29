// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "surefoot/qp_problem.hpp"
#include "surefoot/robot.hpp"
#include "surefoot/task.hpp"
#include "surefoot/types.hpp"

namespace surefoot {

class Dynamics;

/// What is set once, as opposed to tuned.
struct WholeBodyOptions {
  QpForm form = QpForm::kAuto;
  double tolerance = 1e-6;  ///< of the program's residuals, in its own scaling

  /// Throw surefoot::Error naming what is out of range.
  void validate() const;
};

/// State and reference in, joint torques out: for people who bring their own estimator or planner.
///
/// Minimises the missed accelerations of the body (centre of mass or base, orientation, angular
/// momentum), of the posture and of tasks of your own, and the distance from the most even forces.
/// Rigid-body dynamics (armature included) and contact accelerations hold exactly, but for a leg
/// that near the support's edge bears nothing and keeps its joint limits by itself; friction and
/// normal force are hard, f = 0 always allowed; torque by the motors' torque-speed curve, joint
/// position and velocity, and the force that keeps feet down are elastic with exact penalties, so
/// the program is feasible by construction. Torques that leave are clipped to the motors, and the
/// solution says how much that took.
class WholeBodyController {
 public:
  /// Throws surefoot::Error when the robot does not fit the form asked for, or a gain or an option
  /// is invalid.
  explicit WholeBodyController(const Robot& robot);
  WholeBodyController(const Robot& robot, const Gains& gains, const WholeBodyOptions& options = {});
  ~WholeBodyController();
  WholeBodyController(WholeBodyController&&) noexcept;

  /// Compute one tick. Real-time: yes.
  ///
  /// @param state q and v of the robot's size, Pinocchio's order; contact 0 .. 1 per foot
  /// @param reference in the same world frame
  /// @return status kOk or kSaturated, or why the rest, but residuals and iterations, is of the
  /// last good tick
  const Solution& update(const RobotState& state, const Reference& reference) noexcept;

  /// Make the reference that asks the robot to stay as it is: centre of mass, orientation and
  /// contact points where `state` has them, at rest. Throws surefoot::Error on a wrong size.
  Reference hold(const RobotState& state);

  /// update() on dynamics that are computed already (StandController's way in). Real-time: yes.
  /// @param state the same state that the dynamics belong to
  const Solution& solve(const Dynamics& dynamics, const RobotState& state,
                        const Reference& reference) noexcept;

  /// Solve the program of the last solve() or update() once more, when that ended with
  /// kMaxIterations or kInfeasible: without a warm start, in one attempt, to ten times the
  /// tolerance by our own check. After any other status there is no program that could be solved,
  /// and nothing happens. Tasks are not asked again. Real-time: yes.
  /// @param dynamics of that tick
  const Solution& solve_cold(const Dynamics& dynamics) noexcept;

  /// Add a task of your own, from the next tick on. Not in the tick; throws surefoot::Error.
  void add_task(std::shared_ptr<Task> task);

  const Solution& solution() const noexcept;
  /// The quadratic program that the last tick solved, scaled as it was: the hard one, or with
  /// slacks while something gives. For benchmarks and debugging. Real-time: yes.
  const QpProblem& qp() const noexcept;
  const Gains& gains() const noexcept;

  /// Change gains between ticks; throws surefoot::Error and changes nothing if one is invalid.
  void set_gains(const Gains& gains);
  /// The same in the tick. @return false, and nothing is changed, if one is invalid. Real-time:
  /// yes.
  bool adopt_gains(const Gains& gains) noexcept;

  /// Let each motor use only a share of its torque, 0 .. 1, SDK order: a hot one, say. What is not
  /// a share changes nothing. Real-time: yes.
  void set_torque_share(const Vector12& share) noexcept;
  const Vector12& torque_share() const noexcept;

  /// Forget the warm start.
  void reset() noexcept;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace surefoot
