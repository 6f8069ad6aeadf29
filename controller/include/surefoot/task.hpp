// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/types.hpp"

namespace surefoot {

/// Rows of a custom task. The QP adds this cost to its own tasks; a are the generalised
/// accelerations, f the contact forces:
///
///     1/2 sum_i weight_i (A_a a + A_f f - b)_i^2
///
/// For scale: with gain weight_com_vertical = 1, an error of g/2 in the acceleration of the centre
/// of mass costs 1/2. Rows whose cost is more than 1e5 times that of the QP's own tasks end the
/// tick with Status::kBadTask.
struct TaskRows {
  /// Create `rows` rows for a robot with `nv` velocities. A_a, A_f and b are zero, weight is one.
  TaskRows(int rows, int nv)
      : A_a(Eigen::MatrixXd::Zero(rows, nv)),
        A_f(Eigen::MatrixXd::Zero(rows, 3 * kLegs)),
        b(Eigen::VectorXd::Zero(rows)),
        weight(Eigen::VectorXd::Ones(rows)) {}
  Eigen::MatrixXd A_a;     ///< shape (rows, nv), for accelerations in Pinocchio's order
  Eigen::MatrixXd A_f;     ///< shape (rows, 12), for forces [N], world axes, FR FL RR RL
  Eigen::VectorXd b;       ///< desired values, shape (rows,)
  Eigen::VectorXd weight;  ///< weight of each row, shape (rows,), >= 0; initially 1
};

/// Base class of custom tasks, see WholeBodyController::add_task() and examples/custom_task.cpp.
class Task {
 public:
  virtual ~Task() = default;
  /// Return the number of rows, 1 .. 1000. Called once, by add_task(). Real-time: not required.
  virtual int rows() const = 0;
  /// Write the rows for a state. Rows that are not written keep the values of the last tick.
  ///
  /// The acceleration of a frame is J a + Jdot v with v from `state`, in Pinocchio's conventions.
  /// Called in every tick. Real-time: required.
  /// @param state state of this tick
  /// @param rows rows to write
  /// @return false to end the tick with Status::kBadTask, else true. A number that is not finite,
  /// or a negative weight, also ends the tick with kBadTask.
  virtual bool write(const RobotState& state, TaskRows& rows) noexcept = 0;
};

}  // namespace surefoot
