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
    throw std::runtime_error(path + ": not a sequence of QPs");
  }
  ticks_ = static_cast<int>(T);
  first_problem_.n = static_cast<int>(n);
  first_problem_.n_eq = static_cast<int>(eq);
  first_problem_.n_in = static_cast<int>(in);
  const double* next = reinterpret_cast<const double*>(static_cast<char*>(map_) + sizeof header);
  for (auto [field, count] : {std::pair{&first_problem_.H, n * n},
                              {&first_problem_.g, n},
                              {&first_problem_.A, eq * n},
                              {&first_problem_.b, eq},
                              {&first_problem_.C, in * n},
                              {&first_problem_.l, in},
                              {&first_problem_.u, in}}) {
    *field = next;
    next += T * count;
  }
  buffer_.resize(static_cast<std::size_t>(doubles));
  current_problem_ = first_problem_;
}

SequenceFile::~SequenceFile() { munmap(map_, bytes_); }

const Problem& SequenceFile::load(int tick) {
  const int n = first_problem_.n, eq = first_problem_.n_eq, in = first_problem_.n_in;
  double* next = buffer_.data();
  const auto copy = [&](const double*& to, const double* from, int count) {
    std::memcpy(next, from + static_cast<std::ptrdiff_t>(tick) * count, 8 * std::size_t(count));
    to = next;
    next += count;
  };
  copy(current_problem_.H, first_problem_.H, n * n);
  copy(current_problem_.g, first_problem_.g, n);
  copy(current_problem_.A, first_problem_.A, eq * n);
  copy(current_problem_.b, first_problem_.b, eq);
  copy(current_problem_.C, first_problem_.C, in * n);
  copy(current_problem_.l, first_problem_.l, in);
  copy(current_problem_.u, first_problem_.u, in);
  return current_problem_;
}

void SequenceFile::find_patterns(Setup& setup) const {
  setup.H_pattern = nonzero_pattern(first_problem_.H, first_problem_.n * first_problem_.n);
  setup.A_pattern = nonzero_pattern(first_problem_.A, first_problem_.n_eq * first_problem_.n);
  setup.C_pattern = nonzero_pattern(first_problem_.C, first_problem_.n_in * first_problem_.n);
}

std::vector<char> SequenceFile::nonzero_pattern(const double* data, int entries) const {
  std::vector<char> used(static_cast<std::size_t>(entries), 0);
  for (int tick = 0; tick < ticks_; ++tick) {
    for (int i = 0; i < entries; ++i) used[i] |= *data++ != 0.0;
  }
  return used;
}

}  // namespace bench
