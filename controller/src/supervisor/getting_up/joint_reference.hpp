// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/math.hpp"

namespace surefoot {

/// Desired joint angles and velocities, SDK motor order.
struct JointReference {
  Vector12 q = Vector12::Zero();   ///< [rad]
  Vector12 dq = Vector12::Zero();  ///< [rad/s]
};

}  // namespace surefoot
