// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

/// Interface of all solvers. Each adapter is linked into its own executable, so that a crash of one
/// solver does not affect other solvers.
namespace bench {

/// QP: minimise 1/2 x'H x + g'x  subject to  A x = b,  l <= C x <= u. Matrices are dense and
/// row-major; a missing bound is infinite.
struct Problem {
  int n = 0, n_eq = 0, n_in = 0;
  const double *H = nullptr, *g = nullptr, *A = nullptr, *b = nullptr;
  const double *C = nullptr, *l = nullptr, *u = nullptr;
};

/// Status that a solver reports; kUnknown: it reports none.
enum class SolveStatus { kUnknown = 0, kSolved = 1, kFailed = 2 };

/// Solution with H x + g + A'y + C'z = 0. A multiplier z is > 0 where the upper bound u is active,
/// and < 0 where the lower bound l is active.
struct Solution {
  std::vector<double> x, y, z;
};

/// Sizes and settings for a solver: n variables, n_eq equalities and n_in inequalities.
struct Setup {
  int n = 0, n_eq = 0, n_in = 0;
  double tolerance = 1e-6;
  bool warm = true;  ///< true: the solver may start from its result of the last tick
  /// Whether each entry is nonzero in any QP of the sequence, row-major. A user of a sparse solver
  /// would know these patterns beforehand. Empty: all entries are nonzero.
  std::vector<char> H_pattern, A_pattern, C_pattern;
};

/// Texts about a solver for the report; warm_start states what the solver keeps between ticks.
struct Description {
  std::string name, interface, version, settings, warm_start;
};

class Adapter {
 public:
  virtual ~Adapter() = default;
  virtual Description describe() const = 0;
  /// Return false if the solver keeps nothing from one tick to the next.
  virtual bool can_warm_start() const { return true; }
  /// Discard all former solutions; memory and sparsity may stay. Not timed.
  virtual void clear_warm_start() = 0;
  /// Copy the QP into the data structures that a user of the solver would fill. Not timed.
  virtual void load_problem(const Problem& problem) = 0;
  /// Solve the QP, with all conversions that the format of the solver requires. Timed.
  virtual SolveStatus solve() = 0;
  virtual int iterations() const = 0;  ///< -1: not reported
  /// Copy the solution. Not timed.
  virtual void read_solution(Solution& solution) const = 0;
};

/// Create the adapter; every adapter file defines this function.
std::unique_ptr<Adapter> make_adapter(const Setup& setup);

}  // namespace bench
