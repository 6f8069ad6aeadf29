// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surefoot/types.hpp"

namespace surefoot {

/// Carries the state forward to when the next command acts, with the motion that the commands on
/// their way will make: the accelerations of the last solutions, integrated over the delay.
///
/// Real-time: all but the constructor yes.
class DelayPredictor {
 public:
  static constexpr double kLongest = 0.05;  ///< [s]

  /// @param delay from a measurement to the action of the command made from it [s]
  DelayPredictor(int nv, double delay);

  bool active() const noexcept { return delay_ > 0.0; }

  /// Time goes on, and the command sent last has `dt` more of it.
  void elapse(double dt) noexcept;

  /// Note what the command sent now will make from when it acts until the next one does.
  void remember(const Eigen::VectorXd& accelerations) noexcept;

  /// What the command made that acted until now, shape (nv,); null while none has.
  const Eigen::VectorXd* acting() const noexcept;

  /// A state of the same size as `state`, `delay` later.
  const RobotState& predict(const RobotState& state) noexcept;

  void reset() noexcept { count_ = 0; }

 private:
  struct Sent {
    Eigen::VectorXd acceleration;
    double dt = 0.0;
  };
  double delay_;
  std::vector<Sent> sent_;  // a ring, the newest at next_ - 1
  int next_ = 0, count_ = 0;
  Eigen::VectorXd dv_, dq_;
  RobotState predicted_;
};

}  // namespace surefoot
