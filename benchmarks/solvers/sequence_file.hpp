// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "adapter.hpp"

namespace bench {

/// QPs of one size from a raw file: "SFQPSEQ1", int64 n, n_eq, n_in, T, then H (T, n, n), g, A, b,
/// C, l, u as doubles in native byte order.
class SequenceFile {
 public:
  /// @throws std::runtime_error if the file cannot be read or has another format
  explicit SequenceFile(const std::string& path);
  ~SequenceFile();
  SequenceFile(const SequenceFile&) = delete;
  SequenceFile& operator=(const SequenceFile&) = delete;

  int ticks() const { return ticks_; }
  const Problem& first_problem() const { return first_problem_; }
  /// Copy the QP of a tick into a buffer, so that the QP is in the processor's cache.
  const Problem& load(int tick);
  /// Find the entries that are nonzero in any tick.
  void find_patterns(Setup& setup) const;

 private:
  std::vector<char> nonzero_pattern(const double* data, int entries) const;
  void* map_ = nullptr;
  std::size_t bytes_ = 0;
  int ticks_ = 0;
  Problem first_problem_;    // pointers to the first tick
  Problem current_problem_;  // pointers into buffer_
  std::vector<double> buffer_;
};

}  // namespace bench
