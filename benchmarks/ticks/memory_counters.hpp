// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace bench {

/// Calls of malloc and its relatives in the whole program so far.
long heap_allocations() noexcept;

/// Page faults of this thread so far, minor and major.
long page_faults() noexcept;

}  // namespace bench
