// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "adapter.hpp"

namespace bench {

/// Residuals of the optimality conditions (Karush, Kuhn, Tucker), computed in the same way for all
/// solvers. If all three are zero, the solution of a strictly convex QP is exact.
struct Residuals {
  double primal = 0.0;  ///< largest violation of A x = b, l <= C x <= u
  double dual = 0.0;    ///< largest entry of H x + g + A'y + C'z
  /// Complementarity: largest min(|z_i|, 1) times the distance of row i of C x from u_i if z_i > 0,
  /// from l_i otherwise.
  double gap = 0.0;
};

/// Compute the residuals; all infinite if the solution is not finite.
Residuals residuals(const Problem& problem, const Solution& solution);

}  // namespace bench
