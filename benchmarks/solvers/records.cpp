// SPDX-License-Identifier: BSD-3-Clause
#include "records.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace bench {

RecordFile::RecordFile(const std::string& path, int ticks)
    : bytes_(sizeof(Record) * static_cast<std::size_t>(ticks)) {
  const int file = open(path.c_str(), O_RDWR | O_CREAT | O_TRUNC, 0644);
  void* map = MAP_FAILED;
  if (file >= 0 && ftruncate(file, static_cast<off_t>(bytes_)) == 0) {
    map = mmap(nullptr, bytes_, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
  }
  if (file >= 0) close(file);
  if (map == MAP_FAILED) throw std::runtime_error(path + ": cannot be written");
  records_ = static_cast<Record*>(map);
  double* fields = static_cast<double*>(map);
  std::fill(fields, fields + bytes_ / sizeof(double), std::numeric_limits<double>::quiet_NaN());
}

RecordFile::~RecordFile() { munmap(records_, bytes_); }

}  // namespace bench
