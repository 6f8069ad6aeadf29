// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/runner.hpp"

namespace surefoot {

/// Write pose, desired forces, contacts, tracking errors, torques and power of the robot into a
/// snapshot. Real-time: yes.
void write_robot_snapshot(const WalkController& controller, const LowState& state,
                          const Vector12& tau_max, RunSnapshot& snapshot) noexcept;

}  // namespace surefoot
