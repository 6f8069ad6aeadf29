// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "wbc/qp_solver.hpp"

namespace surefoot {

/// Whether an answer is one: residuals on the program as it was posed, whoever solved it.
/// Real-time: all but the constructor, allocates nothing.
class QpCheck {
 public:
  QpCheck(int n, int n_eq, int n_in);

  /// @return kOk: residuals at most 5 times the tolerance, gap at most the tolerance; else
  ///   kMaxIterations
  QpResult operator()(const QpProblem& problem, const Eigen::VectorXd& x, const Eigen::VectorXd& y,
                      const Eigen::VectorXd& z, double tolerance) noexcept;

  /// C x of the answer checked last.
  const Eigen::VectorXd& Cx() const noexcept { return Cx_; }

  /// No NaN anywhere, and infinities only in l and u.
  static bool finite(const QpProblem& problem) noexcept;

  /// min(|z|, 1) times the distance from the bound that z's sign names.
  static double row_gap(double z, double Cx, double l, double u) noexcept;

 private:
  Eigen::VectorXd Ax_, Cx_, gradient_;
};

}  // namespace surefoot
