// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "adapter.hpp"

namespace bench {

/// How far an answer is from optimal, computed here and never taken from a solver. For a strictly
/// convex program all three zero is the answer (Karush, Kuhn and Tucker).
struct Residuals {
  double primal = 0.0;  ///< greatest violation of A x = b, l <= C x <= u
  double dual = 0.0;    ///< greatest entry of H x + g + A'y + C'z
  double gap = 0.0;     ///< greatest min(|z_i|, 1) times row i's distance from the bound it names
};

/// Infinities where anything is not a number.
Residuals residuals(const Problem& problem, const Solution& solution);

}  // namespace bench
