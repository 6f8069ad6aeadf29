// SPDX-License-Identifier: BSD-3-Clause
// Counting versions of malloc and related functions, which replace those of the C library in this
// executable.
#include "memory_counters.hpp"

#include <dlfcn.h>
#include <sys/resource.h>

#include <atomic>
#include <cstddef>

namespace {

std::atomic<long> allocations{0};

template <typename Function>
Function next(const char* name) {
  return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

}  // namespace

extern "C" {
void* malloc(std::size_t size) {
  static const auto real = next<void* (*)(std::size_t)>("malloc");
  ++allocations;
  return real(size);
}
void* realloc(void* old, std::size_t size) {
  static const auto real = next<void* (*)(void*, std::size_t)>("realloc");
  ++allocations;
  return real(old, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) {
  static const auto real = next<void* (*)(std::size_t, std::size_t)>("aligned_alloc");
  ++allocations;
  return real(alignment, size);
}
int posix_memalign(void** out, std::size_t alignment, std::size_t size) {
  static const auto real = next<int (*)(void**, std::size_t, std::size_t)>("posix_memalign");
  ++allocations;
  return real(out, alignment, size);
}
void* __libc_calloc(std::size_t, std::size_t);  // used because dlsym() may call calloc()
void* calloc(std::size_t number, std::size_t size) {
  ++allocations;
  return __libc_calloc(number, size);
}
}

namespace bench {

long heap_allocations() noexcept { return allocations.load(); }

long page_faults() noexcept {
  rusage usage{};
  getrusage(RUSAGE_THREAD, &usage);
  return usage.ru_minflt + usage.ru_majflt;
}

}  // namespace bench
