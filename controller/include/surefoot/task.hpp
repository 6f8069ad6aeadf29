// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/types.hpp"

namespace surefoot {

/// Rows of a custom task. The QP minimises, beside its own tasks,
///   1/2 sum_i weight_i (A_a a + A_f f - b)_i^2
/// over generalised accelerations a and contact forces f.
///
/// For scale: with gain weight_com_vertical = 1, an error of g/2 in the acceleration of the centre
/// of mass costs 1/2. Rows that outweigh the QP's own tasks by more than 1e5 end the tick
/// with Status::kBadTask.
struct TaskRows {
  TaskRows(int rows, int nv)
      : A_a(Eigen::MatrixXd::Zero(rows, nv)),
        A_f(Eigen::MatrixXd::Zero(rows, 3 * kLegs)),
        b(Eigen::VectorXd::Zero(rows)),
        weight(Eigen::VectorXd::Ones(rows)) {}
  Eigen::MatrixXd A_a;     ///< (rows, nv) for the generalised acceleration, Pinocchio's order
  Eigen::MatrixXd A_f;     ///< (rows, 12) for the contact forces [N], world axes, FR FL RR RL
  Eigen::VectorXd b;       ///< (rows,) desired values
  Eigen::VectorXd weight;  ///< (rows,) 0 or more; initially 1
};

/// Base class of custom tasks, see WholeBodyController::add_task() and examples/custom_task.cpp.
class Task {
 public:
  virtual ~Task() = default;
  /// Return the number of rows, 1 .. 1000. Called once, by add_task().
  virtual int rows() const = 0;
  /// Write the rows for a state. Rows keep the values of the last tick until they are written
  /// again.
  ///
  /// The acceleration of a frame is J a + Jdot v with v from `state`, in Pinocchio's conventions.
  /// Real-time: required; called in every tick.
  /// @return false to end the tick with Status::kBadTask. A number that is not finite, or a
  /// negative weight, has the same effect.
  virtual bool write(const RobotState& state, TaskRows& rows) noexcept = 0;
};

}  // namespace surefoot
