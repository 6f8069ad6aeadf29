// SPDX-License-Identifier: BSD-3-Clause
// Surefoot's QpSolver: a dual active-set method, and ProxQP if this method does not converge.
#include "adapter.hpp"
#include "wbc/qp_solver.hpp"

namespace bench {

namespace {

class Surefoot : public Adapter {
 public:
  explicit Surefoot(const Setup& s)
      : problem_(s.n, s.n_eq, s.n_in), solver_(s.n, s.n_eq, s.n_in, s.tolerance) {}

  Description describe() const override {
    return {"surefoot", "c++", SUREFOOT_VERSION,
            "QpSolver: dual active-set method from the last active set, and ProxQP without "
            "preconditioner if that does not converge; tolerance as requested; the check of "
            "residuals and gap after every attempt is part of the timed solve",
            "active set of the last tick; x, y and z for ProxQP"};
  }
  void clear_warm_start() override { solver_.reset(); }
  void load_problem(const Problem& p) override {
    using surefoot::RowMatrix;
    problem_.H = Eigen::Map<const RowMatrix>(p.H, p.n, p.n);
    problem_.A = Eigen::Map<const RowMatrix>(p.A, p.n_eq, p.n);
    problem_.C = Eigen::Map<const RowMatrix>(p.C, p.n_in, p.n);
    problem_.g = Eigen::Map<const Eigen::VectorXd>(p.g, p.n);
    problem_.b = Eigen::Map<const Eigen::VectorXd>(p.b, p.n_eq);
    problem_.l = Eigen::Map<const Eigen::VectorXd>(p.l, p.n_in).cwiseMax(-surefoot::kNoBound);
    problem_.u = Eigen::Map<const Eigen::VectorXd>(p.u, p.n_in).cwiseMin(surefoot::kNoBound);
  }
  SolveStatus solve() override {
    result_ = solver_.solve(problem_);
    return result_.status == surefoot::Status::kOk ? SolveStatus::kSolved : SolveStatus::kFailed;
  }
  int iterations() const override { return result_.iterations; }
  void read_solution(Solution& solution) const override {
    solution.x.assign(solver_.x().begin(), solver_.x().end());
    solution.y.assign(solver_.y().begin(), solver_.y().end());
    solution.z.assign(solver_.z().begin(), solver_.z().end());
  }

 private:
  surefoot::QpProblem problem_;
  surefoot::QpSolver solver_;
  surefoot::QpResult result_;
};

}  // namespace

std::unique_ptr<Adapter> make_adapter(const Setup& setup) {
  return std::make_unique<Surefoot>(setup);
}

}  // namespace bench
