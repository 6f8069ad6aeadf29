// SPDX-License-Identifier: BSD-3-Clause
// Prints controller/src/dynamics/generated/leg_dynamics.hpp; see `make generate`.
#include <iostream>

#include "dynamics/generator/leg_source.hpp"

int main() {
  std::cout << surefoot::generator::leg_source();
  return std::cout.good() ? 0 : 1;
}
