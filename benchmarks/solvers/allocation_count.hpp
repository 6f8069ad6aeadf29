// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace bench {

/// Switch the counting of heap allocations on or off. This executable replaces malloc and related
/// functions, which adds about a nanosecond to each call.
void count_allocations(bool on);
/// Return the number of allocations counted so far.
long allocations();

}  // namespace bench
