// SPDX-License-Identifier: BSD-3-Clause
#include "exact_solver.hpp"

std::unique_ptr<bench::Adapter> bench::make_adapter(const Setup& setup) {
  return std::make_unique<ExactSolver>(setup);
}
