// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dynamics/dynamics.hpp"
#include "surefoot/gains.hpp"
#include "surefoot/types.hpp"

namespace surefoot {

/// Compute the acceleration [m/s^2] by which the feet of a robot that stands are held more stiffly
/// than with foot_kp and foot_kd, world axes, one column per foot.
///
/// No friction of the ground holds a foot without load, and the friction of its joints drags it
/// along with the body. The result is zero for feet with load, for swing feet, and while the robot
/// steps. A foot that has lost its contact counts as loaded: something has lifted it, and the robot
/// must not press it down. Real-time: yes.
/// @param loads planned normal force of each foot in the last tick, as a share of the weight
FeetMatrix unloaded_feet_hold(const Gains& gains, const Dynamics& dynamics, const RobotState& state,
                              const Reference& reference, const Eigen::Vector4d& loads) noexcept;

}  // namespace surefoot
