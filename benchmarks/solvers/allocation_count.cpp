// SPDX-License-Identifier: BSD-3-Clause
#include "allocation_count.hpp"

#include <cstddef>

namespace {
bool counting = false;  // not atomic: there is one thread
long count = 0;
}  // namespace

// glibc's own names of the original functions. This file calls the functions by these names,
// because a look-up with dlsym(RTLD_NEXT, ...) would itself allocate.
extern "C" {
void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);

void* malloc(std::size_t size) {
  count += counting;
  return __libc_malloc(size);
}
void* calloc(std::size_t number, std::size_t size) {
  count += counting;
  return __libc_calloc(number, size);
}
void* realloc(void* old, std::size_t size) {
  count += counting;
  return __libc_realloc(old, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) {
  count += counting;
  return __libc_memalign(alignment, size);
}
void* memalign(std::size_t alignment, std::size_t size) {
  count += counting;
  return __libc_memalign(alignment, size);
}
int posix_memalign(void** out, std::size_t alignment, std::size_t size) {
  count += counting;
  *out = __libc_memalign(alignment, size);
  return *out == nullptr ? 12 : 0;  // ENOMEM
}
}

namespace bench {
void count_allocations(bool on) { counting = on; }
long allocations() { return count; }
}  // namespace bench
