// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/robot.hpp"
#include "surefoot/types.hpp"

namespace surefoot {

/// Can state and reference be computed with? kOk, or the first thing that is wrong. Real-time: yes.
Status check_state(const RobotState& state, const Robot& robot) noexcept;
Status check_reference(const Reference& reference, const Robot& robot) noexcept;

}  // namespace surefoot
