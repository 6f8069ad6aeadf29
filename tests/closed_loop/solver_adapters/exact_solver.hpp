// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "adapter.hpp"

// Exact solver for H = C = identity: minimise 1/2 |x|^2 + g'x subject to l <= x <= u.
// Solution: x = clamp(-g, l, u), z = -(x + g).
class ExactSolver : public bench::Adapter {
 public:
  explicit ExactSolver(const bench::Setup& setup) : x_(setup.n), z_(setup.n) {}
  bench::Description describe() const override {
    return {"fake", "c++", "1", "knows the answer", "counts its solves"};
  }
  void clear_warm_start() override { solve_count_ = 0; }
  void load_problem(const bench::Problem& p) override { problem_ = p; }
  bench::SolveStatus solve() override {
    ++solve_count_;
    for (int i = 0; i < problem_.n; ++i) {
      const double unconstrained = -problem_.g[i];
      const double l = problem_.l[i], u = problem_.u[i];
      x_[i] = unconstrained < l ? l : unconstrained > u ? u : unconstrained;
      z_[i] = unconstrained - x_[i];
    }
    return bench::SolveStatus::kSolved;
  }
  int iterations() const override { return solve_count_; }
  void read_solution(bench::Solution& solution) const override {
    solution.x = x_;
    solution.z = z_;
  }

 protected:
  bench::Problem problem_;
  std::vector<double> x_, z_;
  int solve_count_ = 0;
};
