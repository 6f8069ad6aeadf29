// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/robot.hpp"
#include "surefoot/types.hpp"

namespace surefoot {

/// Check sizes, finite values and ranges of a state or a reference. Real-time: yes.
/// @return kOk, or the status of the first error
Status check_state(const RobotState& state, const Robot& robot) noexcept;
Status check_reference(const Reference& reference, const Robot& robot) noexcept;

}  // namespace surefoot
