// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

/// A small interface that every solver is put behind. Each adapter is linked into a program of its
/// own, so that one that crashes takes no other down.
namespace bench {

/// minimise 1/2 x'H x + g'x  subject to  A x = b,  l <= C x <= u; matrices row-major and dense,
/// no bound is an infinity.
struct Problem {
  int n = 0, n_eq = 0, n_in = 0;
  const double *H = nullptr, *g = nullptr, *A = nullptr, *b = nullptr;
  const double *C = nullptr, *l = nullptr, *u = nullptr;
};

/// What a solver says of its answer.
enum class SolveStatus { kUnknown = 0, kSolved = 1, kFailed = 2 };

/// H x + g + A'y + C'z = 0; z > 0 pushes from u, z < 0 from l.
struct Solution {
  std::vector<double> x, y, z;
};

/// How a solver is asked to work.
struct Setup {
  int n = 0, n_eq = 0, n_in = 0;
  double tolerance = 1e-6;
  bool warm = true;  ///< state is kept from tick to tick
  /// Entries that are not zero in any of the programs, row-major: what a user of a sparse solver
  /// knows beforehand. Empty means all.
  std::vector<char> H_pattern, A_pattern, C_pattern;
};

struct Description {
  std::string name, interface, version, settings, warm_start;
};

class Adapter {
 public:
  virtual ~Adapter() = default;
  virtual Description describe() const = 0;
  /// False if it has nothing to keep from one tick to the next.
  virtual bool can_warm_start() const { return true; }
  /// Not timed. Forget all answers; memory and sparsity may stay.
  virtual void clear_warm_start() = 0;
  /// Not timed. Put the program where a user would have written it in the first place.
  virtual void load_problem(const Problem& problem) = 0;
  /// Timed: all that a tick needs, conversions that the solver's format forces included.
  virtual SolveStatus solve() = 0;
  virtual int iterations() const = 0;  ///< -1: it does not say
  /// Not timed.
  virtual void read_solution(Solution& solution) const = 0;
};

/// Every adapter's file defines this one.
std::unique_ptr<Adapter> make_adapter(const Setup& setup);

}  // namespace bench
