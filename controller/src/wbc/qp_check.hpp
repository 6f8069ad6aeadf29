// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "wbc/qp_solver.hpp"

namespace surefoot {

/// Checks a solution by its residuals on the original QP, independent of the solver. Real-time: all
/// functions except the constructor; allocates nothing.
class QpCheck {
 public:
  QpCheck(int n, int n_eq, int n_in);

  /// Compute the residuals of x, y, z.
  /// @return residuals and gap. The status is kOk if the residuals are at most 5 times the
  ///   tolerance and the gap is at most the tolerance; otherwise it is kMaxIterations, which here
  ///   only means: not accurate enough
  QpResult operator()(const QpProblem& problem, const Eigen::VectorXd& x, const Eigen::VectorXd& y,
                      const Eigen::VectorXd& z, double tolerance) noexcept;

  /// C x of the last checked solution.
  const Eigen::VectorXd& Cx() const noexcept { return Cx_; }

  /// Return true if the QP has no NaN, and no infinite entry except in l and u.
  static bool finite(const QpProblem& problem) noexcept;

  /// Return min(|z|, 1) times the distance of Cx from its bound: u for z > 0, else l. If this bound
  /// is missing, the distance is 1.
  static double row_gap(double z, double Cx, double l, double u) noexcept;

 private:
  Eigen::VectorXd Ax_, Cx_, gradient_;
};

}  // namespace surefoot
