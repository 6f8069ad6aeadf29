// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "surefoot/qp_problem.hpp"

namespace surefoot {

/// ProxQP's dense solver for scaled QPs of one size, without memory allocation in run().
///
/// x, y and z are the initial guess before run(), and its result afterwards. The caller must check
/// the result. Real-time: all functions except the constructor.
class ProxqpRunner {
 public:
  ProxqpRunner(int n, int n_eq, int n_in);
  ~ProxqpRunner();

  void set_tolerance(double tolerance) noexcept;

  /// Copy the QP into ProxQP's model.
  void set_problem(const QpProblem& problem) noexcept;

  struct Outcome {
    int iterations = 0;       ///< inner iterations
    bool infeasible = false;  ///< ProxQP reports primal or dual infeasibility
  };
  /// Solve the QP of set_problem(), warm started with x, y and z.
  Outcome run() noexcept;

  Eigen::VectorXd& x() noexcept;
  Eigen::VectorXd& y() noexcept;  ///< multipliers of A x = b
  Eigen::VectorXd& z() noexcept;  ///< multipliers of l <= C x <= u

 private:
  struct Workspace;
  std::unique_ptr<Workspace> workspace_;
};

}  // namespace surefoot
