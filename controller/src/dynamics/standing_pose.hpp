// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dynamics/dynamics.hpp"

namespace surefoot {

/// Return the kinematics and dynamics in the standing pose, at rest on level ground. Real-time: no.
Dynamics standing_dynamics(const Robot& robot);

/// Return the height of the centre of mass above the contact points in the standing pose [m].
/// Real-time: no.
double standing_com_height(const Robot& robot);

}  // namespace surefoot
