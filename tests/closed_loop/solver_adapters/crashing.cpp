// SPDX-License-Identifier: BSD-3-Clause
// Solver that crashes in the third solve after clear_warm_start().
#include <csignal>

#include "exact_solver.hpp"

namespace {

class CrashingSolver : public ExactSolver {
 public:
  using ExactSolver::ExactSolver;
  bench::SolveStatus solve() override {
    if (solve_count_ == 2) std::raise(SIGSEGV);
    return ExactSolver::solve();
  }
};

}  // namespace

std::unique_ptr<bench::Adapter> bench::make_adapter(const Setup& setup) {
  return std::make_unique<CrashingSolver>(setup);
}
