// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/math.hpp"

namespace surefoot {

/// Where the joints are to be, and how fast they go there; SDK motor order.
struct JointReference {
  Vector12 q = Vector12::Zero();   ///< [rad]
  Vector12 dq = Vector12::Zero();  ///< [rad/s]
};

}  // namespace surefoot
