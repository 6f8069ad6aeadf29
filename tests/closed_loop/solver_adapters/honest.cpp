// SPDX-License-Identifier: BSD-3-Clause
#include "fake.hpp"

std::unique_ptr<bench::Adapter> bench::make_adapter(const Setup& setup) {
  return std::make_unique<Fake>(setup);
}
