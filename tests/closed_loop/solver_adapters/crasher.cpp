// SPDX-License-Identifier: BSD-3-Clause
// Its third solve in a row ends the process.
#include <csignal>

#include "fake.hpp"

namespace {

class Crasher : public Fake {
 public:
  using Fake::Fake;
  bench::Said solve() override {
    if (solves_ == 2) std::raise(SIGSEGV);
    return Fake::solve();
  }
};

}  // namespace

std::unique_ptr<bench::Adapter> bench::make_adapter(const Setup& setup) {
  return std::make_unique<Crasher>(setup);
}
