// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/stand_runner.hpp"

namespace surefoot {

/// Write into a snapshot what can be seen of the robot: pose, forces, how far it is from where it
/// should be, how hard its motors work. Real-time: yes.
void view_robot(const StandController& controller, const LowState& state, const Vector12& tau_max,
                RunSnapshot& now) noexcept;

}  // namespace surefoot
