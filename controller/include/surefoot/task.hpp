// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/types.hpp"

namespace surefoot {

/// Rows of a task: A_a a + A_f f = b is wanted, and missed as cheaply as `weight` says.
///
/// The program minimises 1/2 sum weight_i (A_a a + A_f f - b)_i^2 beside its own tasks; for scale:
/// at weight 1 the centre of mass pays 1/2 for missing its acceleration by g/2. Rows that outweigh
/// the program's own tasks a hundred thousand times stop the tick with Status::kBadTask.
struct TaskRows {
  TaskRows(int rows, int nv)
      : A_a(Eigen::MatrixXd::Zero(rows, nv)),
        A_f(Eigen::MatrixXd::Zero(rows, 3 * kLegs)),
        b(Eigen::VectorXd::Zero(rows)),
        weight(Eigen::VectorXd::Ones(rows)) {}
  Eigen::MatrixXd A_a;     ///< (rows, nv) on the generalised acceleration, Pinocchio's order
  Eigen::MatrixXd A_f;     ///< (rows, 12) on the contact forces, world axes, FR FL RR RL
  Eigen::VectorXd b;       ///< (rows,)
  Eigen::VectorXd weight;  ///< (rows,) 0 or more
};

/// A task of your own, added with add_task(). See examples/custom_task.
class Task {
 public:
  virtual ~Task() = default;
  /// How many rows it has; asked once.
  virtual int rows() const = 0;
  /// Write the rows for this state; they keep what was written the tick before.
  ///
  /// A frame's acceleration is J a + Jdot v with v as in `state`, Pinocchio's conventions.
  /// @return false to stop the tick with Status::kBadTask; so does a number that is not finite
  /// Real-time: must be; called in every tick.
  virtual bool write(const RobotState& state, TaskRows& rows) noexcept = 0;
};

}  // namespace surefoot
