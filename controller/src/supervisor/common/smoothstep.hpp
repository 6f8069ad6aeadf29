// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

namespace surefoot {

/// Return x^2 (3 - 2 x) with x clamped to 0 .. 1: a cubic step with zero slope at both ends.
/// Real-time: yes.
inline double smoothstep(double x) noexcept {
  x = std::clamp(x, 0.0, 1.0);
  return x * x * (3.0 - 2.0 * x);
}

}  // namespace surefoot
