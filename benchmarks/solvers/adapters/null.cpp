// SPDX-License-Identifier: BSD-3-Clause
// Adapter that does nothing. Its time is the overhead of the clocks and the call, which is part of
// all solver times.
#include "adapter.hpp"

namespace bench {

namespace {

class Null : public Adapter {
 public:
  Description describe() const override { return {"null loop", "c++", "-", "solves nothing", "-"}; }
  void clear_warm_start() override {}
  void load_problem(const Problem&) override {}
  SolveStatus solve() override { return SolveStatus::kUnknown; }
  int iterations() const override { return 0; }
  void read_solution(Solution&) const override {}
};

}  // namespace

std::unique_ptr<Adapter> make_adapter(const Setup&) { return std::make_unique<Null>(); }

}  // namespace bench
