// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/low_level.hpp"

namespace surefoot {

/// Is every floating-point field that the controller uses finite, and no larger than any sensor of
/// these robots can mean (1e4 in its unit)? Real-time: yes.
bool finite(const LowState& state) noexcept;

}  // namespace surefoot
