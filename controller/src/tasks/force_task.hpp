// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tasks/task.hpp"

namespace surefoot {

/// Most even contact forces that meet both tasks:
///   minimise sum |f_i|^2 / share_i   subject to  A_1 f = b_1,  A_2 f = b_2
/// Regularising towards them leaves the tasks exact while no limit is active, so the weight of the
/// regularisation is free to serve the program's conditioning.
/// @param share how much of the load each foot may take, 0 .. 1, FR FL RR RL
/// Real-time: yes.
Vector12 even_forces(const TaskRows& first, const TaskRows& second,
                     const Eigen::Vector4d& share) noexcept;

}  // namespace surefoot
