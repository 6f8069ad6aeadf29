// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "adapter.hpp"

// A solver of  1/2 |x|^2 + g'x,  l <= x <= u  (H = C = identity): x = clamp(-g), z = -(x + g).
class Fake : public bench::Adapter {
 public:
  explicit Fake(const bench::Setup& setup) : x_(setup.n), z_(setup.n) {}
  bench::Description describe() const override {
    return {"fake", "c++", "1", "knows the answer", "counts its solves"};
  }
  void forget() override { solves_ = 0; }
  void take(const bench::Problem& p) override { problem_ = p; }
  bench::Said solve() override {
    ++solves_;
    for (int i = 0; i < problem_.n; ++i) {
      const double free = -problem_.g[i];
      const double l = problem_.l[i], u = problem_.u[i];
      x_[i] = free < l ? l : free > u ? u : free;
      z_[i] = free - x_[i];
    }
    return bench::Said::kSolved;
  }
  int iterations() const override { return solves_; }
  void read(bench::Answer& answer) const override {
    answer.x = x_;
    answer.z = z_;
  }

 protected:
  bench::Problem problem_;
  std::vector<double> x_, z_;
  int solves_ = 0;
};
