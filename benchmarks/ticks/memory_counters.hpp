// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace bench {

/// Return the number of calls of malloc and related functions in this process so far.
long heap_allocations() noexcept;

/// Return the number of page faults of this thread so far, minor and major.
long page_faults() noexcept;

}  // namespace bench
