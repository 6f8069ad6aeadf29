// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surefoot/types.hpp"

namespace surefoot {

/// A command that was sent, and the motion that was planned with it.
struct SentCommand {
  Eigen::VectorXd accelerations;  ///< planned motion, Pinocchio's order and base axes, shape (nv,)
  Vector12 tau = Vector12::Zero();   ///< [N.m] commanded torques, SDK motor order
  Vector3 f_push = Vector3::Zero();  ///< [N] push that the plan accounts for, world axes
  /// [s] Time from sending this command to sending the next command.
  double dt = 0.0;
};

/// Predictor of the state at the time when the next command acts.
///
/// The predictor integrates the planned accelerations a_k of the commands already sent over the
/// delay. Command k acts for the time dt_k within the delay:
///   v(t + delay) = v(t) + sum over the commands k of dt_k a_k
/// Real-time: all functions except the constructor.
class DelayPredictor {
 public:
  /// [s] Largest `delay`. Chosen longer than the delay of a robot's link. At 1 kHz it contains 50
  /// commands; the buffer holds 64 (kCapacity).
  static constexpr double kMaxDelay = 0.05;

  /// @param delay time [s] from a measurement until the command computed from it acts
  DelayPredictor(int nv, double delay);

  /// Return the time [s] over which predict() predicts: the delay, or if it is 0, two periods: one
  /// until the sample arrives, and one until the command acts.
  /// @param period time between two commands [s]
  double horizon(double period) const noexcept;

  /// Advance the time by `dt` [s]: the command that was sent last has acted for `dt` longer.
  void advance(double dt) noexcept;

  /// Record the command that is sent now, and its planned motion.
  /// @param accelerations accelerations that the command causes, shape (nv,)
  /// @param tau commanded torques, SDK motor order [N.m]
  /// @param f_push push that the accelerations take into account, world axes [N]
  void record(const Eigen::VectorXd& accelerations, const Vector12& tau,
              const Vector3& f_push) noexcept;

  /// Return the command that acted when the newest sample was measured, horizon() ago, or null if
  /// no command acted.
  const SentCommand* acting_command(double period) const noexcept;

  /// Return the predicted state at the time horizon() after `state`. Until the next call, the
  /// caller may change the result.
  RobotState& predict(const RobotState& state, double period) noexcept;

  void reset() noexcept { count_ = 0; }

 private:
  double delay_;
  std::vector<SentCommand> sent_;  // ring buffer; the newest is at next_ - 1
  int next_ = 0, count_ = 0;
  Eigen::VectorXd dv_, dq_;
  RobotState predicted_;
};

}  // namespace surefoot
