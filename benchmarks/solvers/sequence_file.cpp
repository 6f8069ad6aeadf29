// SPDX-License-Identifier: BSD-3-Clause
#include "sequence_file.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdint>
#include <cstring>
#include <stdexcept>

namespace bench {

namespace {

struct Header {
  char magic[8];
  std::int64_t n, n_eq, n_in, ticks;
};

}  // namespace

SequenceFile::SequenceFile(const std::string& path) {
  const int file = open(path.c_str(), O_RDONLY);
  struct stat status{};
  if (file < 0 || fstat(file, &status) != 0) throw std::runtime_error(path + ": cannot be read");
  bytes_ = static_cast<std::size_t>(status.st_size);
  map_ = mmap(nullptr, bytes_, PROT_READ, MAP_PRIVATE, file, 0);
  close(file);
  Header header{};
  if (map_ != MAP_FAILED && bytes_ >= sizeof header) std::memcpy(&header, map_, sizeof header);
  const std::int64_t n = header.n, eq = header.n_eq, in = header.n_in, T = header.ticks;
  const std::int64_t doubles = n * n + n + eq * n + eq + in * n + 2 * in;
  if (std::memcmp(header.magic, "SFQPSEQ1", 8) != 0 ||
      bytes_ != sizeof header + static_cast<std::size_t>(8 * T * doubles)) {
    throw std::runtime_error(path + ": is no sequence of programs");
  }
  ticks_ = static_cast<int>(T);
  size_.n = static_cast<int>(n);
  size_.n_eq = static_cast<int>(eq);
  size_.n_in = static_cast<int>(in);
  const double* next = reinterpret_cast<const double*>(static_cast<char*>(map_) + sizeof header);
  for (auto [field, count] : {std::pair{&size_.H, n * n},
                              {&size_.g, n},
                              {&size_.A, eq * n},
                              {&size_.b, eq},
                              {&size_.C, in * n},
                              {&size_.l, in},
                              {&size_.u, in}}) {
    *field = next;
    next += T * count;
  }
  buffer_.resize(static_cast<std::size_t>(doubles));
  now_ = size_;
}

SequenceFile::~SequenceFile() { munmap(map_, bytes_); }

const Problem& SequenceFile::load(int tick) {
  const int n = size_.n, eq = size_.n_eq, in = size_.n_in;
  double* next = buffer_.data();
  const auto copy = [&](const double*& to, const double* from, int count) {
    std::memcpy(next, from + static_cast<std::ptrdiff_t>(tick) * count, 8 * std::size_t(count));
    to = next;
    next += count;
  };
  copy(now_.H, size_.H, n * n);
  copy(now_.g, size_.g, n);
  copy(now_.A, size_.A, eq * n);
  copy(now_.b, size_.b, eq);
  copy(now_.C, size_.C, in * n);
  copy(now_.l, size_.l, in);
  copy(now_.u, size_.u, in);
  return now_;
}

void SequenceFile::patterns(Setup& setup) const {
  setup.H_pattern = pattern(size_.H, size_.n * size_.n);
  setup.A_pattern = pattern(size_.A, size_.n_eq * size_.n);
  setup.C_pattern = pattern(size_.C, size_.n_in * size_.n);
}

std::vector<char> SequenceFile::pattern(const double* data, int entries) const {
  std::vector<char> used(static_cast<std::size_t>(entries), 0);
  for (int tick = 0; tick < ticks_; ++tick) {
    for (int i = 0; i < entries; ++i) used[i] |= *data++ != 0.0;
  }
  return used;
}

}  // namespace bench
