// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "surefoot/qp_problem.hpp"

namespace surefoot {

/// ProxQP's dense solver on scaled problems of one size, with nothing allocated in a run.
///
/// x, y and z are where a run starts and what it ends with; what they are worth is the caller's to
/// check. Real-time: all but the constructor.
class ProxqpRunner {
 public:
  ProxqpRunner(int n, int n_eq, int n_in);
  ~ProxqpRunner();

  void set_tolerance(double tolerance) noexcept;

  /// Copy the problem to where ProxQP looks for it.
  void set_problem(const QpProblem& problem) noexcept;

  struct Outcome {
    int iterations = 0;       ///< inner ones
    bool infeasible = false;  ///< is what it says
  };
  /// Solve what was taken, from x, y and z.
  Outcome run() noexcept;

  Eigen::VectorXd& x() noexcept;
  Eigen::VectorXd& y() noexcept;  ///< multipliers of A x = b
  Eigen::VectorXd& z() noexcept;  ///< multipliers of l <= C x <= u

 private:
  struct Workspace;
  std::unique_ptr<Workspace> workspace_;
};

}  // namespace surefoot
