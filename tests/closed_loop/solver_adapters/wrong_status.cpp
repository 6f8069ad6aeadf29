// SPDX-License-Identifier: BSD-3-Clause
// Solver with wrong statuses. Warm: reports a wrong solution as solved. Cold: finds the solution
// but reports failed for g[0] > 0, and no status otherwise. Every solve allocates memory.
#include "exact_solver.hpp"

namespace {

class WrongStatusSolver : public ExactSolver {
 public:
  explicit WrongStatusSolver(const bench::Setup& setup) : ExactSolver(setup), warm_(setup.warm) {}
  bench::SolveStatus solve() override {
    std::vector<double>(100).swap(discarded_);
    ExactSolver::solve();
    if (warm_) x_[0] += 1e-4;
    if (warm_) return bench::SolveStatus::kSolved;
    return problem_.g[0] > 0.0 ? bench::SolveStatus::kFailed : bench::SolveStatus::kUnknown;
  }

 private:
  bool warm_;
  std::vector<double> discarded_;
};

}  // namespace

std::unique_ptr<bench::Adapter> bench::make_adapter(const Setup& setup) {
  return std::make_unique<WrongStatusSolver>(setup);
}
