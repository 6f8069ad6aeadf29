// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surefoot/robot.hpp"

namespace surefoot {

/// One joint as the program sees it.
struct JointRow {
  int v = 0;       ///< index in v
  int q = -1;      ///< index in q; -1: no angle that could be limited or held
  int motor = -1;  ///< SDK motor, or -1 for a joint beyond the twelve
  int group = 0;   ///< leg 0 .. 3; 4 for joints beyond
  double q_lower = 0.0, q_upper = 0.0, dq_max = 0.0, tau_max = 0.0, q_standing = 0.0;
};

/// The joints in the program's order: SDK motors first, then any others of the model.
using JointTable = std::vector<JointRow>;

/// Limits of the twelve come from the configuration, ranges as motion_range() has them, of the
/// others from the model.
JointTable make_joint_table(const Robot& robot);

}  // namespace surefoot
