// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surefoot/types.hpp"

namespace surefoot {

/// A command that was sent, and its planned motion.
struct SentCommand {
  Eigen::VectorXd accelerations;  ///< planned motion, Pinocchio's order and base axes, shape (nv,)
  Vector12 tau = Vector12::Zero();   ///< [N.m] commanded torques, SDK motor order
  Vector3 f_push = Vector3::Zero();  ///< [N] push that the plan accounts for, world axes
  double dt = 0.0;                   ///< [s] from sending this command to sending the next one
};

/// Predictor of the state at the time when the next command acts.
///
/// Over the delay, it integrates the planned accelerations a_k of the commands already sent.
/// Command k acts for the time dt_k within the delay:
///   v(t + delay) = v(t) + sum over the commands k of dt_k a_k
/// Real-time: yes, except the constructor.
class DelayPredictor {
 public:
  /// [s] Largest `delay`. Chosen. Longer than the delay of a robot's link, and within the memory of
  /// sent commands.
  static constexpr double kMaxDelay = 0.05;

  /// @param delay time from a measurement to the action of the command computed from it [s]
  DelayPredictor(int nv, double delay);

  /// Return whether the delay is above 0, so that the state must be predicted.
  bool active() const noexcept { return delay_ > 0.0; }

  /// Advance the time by `dt` [s]: add it to the time of the last command sent.
  void advance(double dt) noexcept;

  /// Record the command that is sent now, and its planned motion.
  /// @param accelerations planned, shape (nv,)
  /// @param scale share of `accelerations` and `f_push` that the command produces, 0 .. 1
  /// @param tau commanded torques, SDK motor order [N.m]
  /// @param f_push push that the accelerations account for, world axes [N]
  void record(const Eigen::VectorXd& accelerations, double scale, const Vector12& tau,
              const Vector3& f_push) noexcept;

  /// Return the command that acted when the newest sample was measured, or null if none did. With
  /// a delay of 0, the sample and the command are assumed to take one period each.
  /// @param period time between two commands [s]
  const SentCommand* acting_command(double period) const noexcept;

  /// Return the predicted state at the time `delay` after `state`. The caller may change the result
  /// until the next call.
  RobotState& predict(const RobotState& state) noexcept;

  void reset() noexcept { count_ = 0; }

 private:
  double delay_;
  std::vector<SentCommand> sent_;  // ring buffer; the newest is at next_ - 1
  int next_ = 0, count_ = 0;
  Eigen::VectorXd dv_, dq_;
  RobotState predicted_;
};

}  // namespace surefoot
