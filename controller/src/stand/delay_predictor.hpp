// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surefoot/types.hpp"

namespace surefoot {

/// A command on its way to the motors, or past them.
struct SentCommand {
  Eigen::VectorXd accelerations;     ///< that it is to make, Pinocchio's axes, shape (nv,)
  Vector12 tau = Vector12::Zero();   ///< [N.m] SDK motor order
  Vector3 f_push = Vector3::Zero();  ///< [N] push that it counted with, world axes
  double dt = 0.0;                   ///< [s] for which it acts
};

/// Carries the state forward to when the next command acts, with the motion that the commands on
/// their way will make: the accelerations of the last solutions, integrated over the delay.
///
/// Real-time: all but the constructor yes.
class DelayPredictor {
 public:
  static constexpr double kMaxDelay = 0.05;  ///< [s]

  /// @param delay from a measurement to the action of the command made from it [s]
  DelayPredictor(int nv, double delay);

  bool active() const noexcept { return delay_ > 0.0; }

  /// Time goes on, and the command sent last has `dt` more of it.
  void advance(double dt) noexcept;

  /// Note what the command sent now will make from when it acts until the next one does.
  /// @param accelerations shape (nv,) @param f_push [N] that they count with, world axes
  /// @param scale of both that is made @param tau [N.m] SDK motor order
  void record(const Eigen::VectorXd& accelerations, double scale, const Vector12& tau,
              const Vector3& f_push) noexcept;

  /// The command that the newest report tells of; null while none has acted. Where there is nothing
  /// to predict, a report and a command are taken to be on their way for a period each.
  /// @param period of commands [s]
  const SentCommand* acting_command(double period) const noexcept;

  /// A state of the same size as `state`, `delay` later; the caller's until the next call.
  RobotState& predict(const RobotState& state) noexcept;

  void reset() noexcept { count_ = 0; }

 private:
  double delay_;
  std::vector<SentCommand> sent_;  // a ring, the newest at next_ - 1
  int next_ = 0, count_ = 0;
  Eigen::VectorXd dv_, dq_;
  RobotState predicted_;
};

}  // namespace surefoot
