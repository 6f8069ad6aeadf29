// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/stand_runner.hpp"

namespace surefoot {

/// Write into a snapshot what can be seen of the robot: pose, forces, how far it is from where it
/// should be, how hard its motors work. Real-time: yes.
void write_robot_snapshot(const StandController& controller, const LowState& state,
                          const Vector12& tau_max, RunSnapshot& snapshot) noexcept;

}  // namespace surefoot
