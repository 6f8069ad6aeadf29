// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace bench {

/// Heap allocations of the whole program while counting is on; malloc and its relatives are
/// replaced, which costs each of them about a nanosecond.
void count_allocations(bool on);
long allocations();

}  // namespace bench
