// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/robot.hpp"
#include "tasks/task.hpp"
#include "wbc/friction_cone.hpp"
#include "wbc/limits.hpp"
#include "wbc/qp_solver.hpp"

namespace surefoot {

/// The quadratic program of one tick: contact forces in units of a quarter of the weight.
///
/// Rows of C, per foot: kFacets of the friction pyramid, then the normal force; then one per motor.
/// f = 0 always satisfies them, so the program is feasible by construction: a torque bound that
/// f = 0 misses is opened just as far as f = 0 needs.
class WholeBodyProgram {
 public:
  static constexpr int kForces = 3 * kLegs;
  static constexpr int kFootRows = kFacets + 1;
  static constexpr int kRows = kLegs * kFootRows + kMotors;

  explicit WholeBodyProgram(const Robot& robot);

  double force_unit() const noexcept { return force_unit_; }  ///< [N]
  /// [m^3] of a leg's Jacobian: with less, the condensed form does not hold.
  double smallest_determinant() const noexcept { return smallest_determinant_; }
  const QpProblem& problem() const noexcept { return problem_; }

  /// Write the cost: both tasks, and the pull towards `even`. Scaled to trace(H) = 12.
  void set_cost(const Gains& gains, const TaskRows& com, const TaskRows& orientation,
                const Vector12& even) noexcept;

  /// Write friction and normal-force rows.
  /// @param maximum greatest normal force of each foot [N]; 0: no force of any direction
  void set_friction(const Vector3& normal, double friction,
                    const Eigen::Vector4d& maximum) noexcept;

  /// Write torque rows: -limit <= T f + t0 <= limit.
  void set_torque_limits(const Condensed& condensed, const TorqueLimits& limits) noexcept;

 private:
  void add_task(const TaskRows& rows, const Vector3& scale) noexcept;

  Vector12 tau_max_;
  double force_unit_;
  double smallest_determinant_;
  Vector3 com_scale_, angular_scale_;  // rows to length one in the standing pose
  QpProblem problem_;
};

}  // namespace surefoot
