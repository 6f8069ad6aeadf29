// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>

namespace bench {

/// Record of one solve; all fields are doubles, so that NumPy reads the file as a (T, 9) array.
/// `distance` is the largest absolute difference between an entry of x and the same entry of the
/// reference answer; NaN without a reference answer.
struct Record {
  double wall_ns, cpu_ns, status, iterations, allocations, primal, dual, gap, distance;
};

/// Records in a memory-mapped file, which keeps the finished records after a crash. A tick that was
/// not reached has NaN in every field.
class RecordFile {
 public:
  /// @throws std::runtime_error if the file cannot be written
  RecordFile(const std::string& path, int ticks);
  ~RecordFile();
  RecordFile(const RecordFile&) = delete;
  RecordFile& operator=(const RecordFile&) = delete;
  Record& operator[](int tick) { return records_[tick]; }

 private:
  Record* records_ = nullptr;
  std::size_t bytes_ = 0;
};

}  // namespace bench
