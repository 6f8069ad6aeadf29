// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

namespace surefoot {

/// 0 for x <= 0, 1 for x >= 1, between them a cubic with no slope at either end.
inline double smoothstep(double x) noexcept {
  x = std::clamp(x, 0.0, 1.0);
  return x * x * (3.0 - 2.0 * x);
}

}  // namespace surefoot
