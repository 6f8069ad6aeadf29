// SPDX-License-Identifier: BSD-3-Clause
// Warm: says solved of an answer that is off. Cold: says nothing, or that it failed where it has
// not, by turns of the program's first entry. Has nothing against the heap.
#include "fake.hpp"

namespace {

class Liar : public Fake {
 public:
  explicit Liar(const bench::Setup& setup) : Fake(setup), warm_(setup.warm) {}
  bench::Said solve() override {
    std::vector<double>(100).swap(waste_);
    Fake::solve();
    if (warm_) x_[0] += 1e-4;
    if (warm_) return bench::Said::kSolved;
    return problem_.g[0] > 0.0 ? bench::Said::kFailed : bench::Said::kNothing;
  }

 private:
  bool warm_;
  std::vector<double> waste_;
};

}  // namespace

std::unique_ptr<bench::Adapter> bench::make_adapter(const Setup& setup) {
  return std::make_unique<Liar>(setup);
}
