// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surefoot/robot.hpp"

namespace surefoot {

/// One joint of the QP: its indices and limits, in SI units.
struct JointRow {
  int v = 0;       ///< index in v
  int q = -1;      ///< index in q; -1: the joint has no single angle
  int motor = -1;  ///< SDK motor, or -1 for a further joint
  int group = 0;   ///< leg 0 .. 3; 4 for further joints
  double q_lower = 0.0, q_upper = 0.0, dq_max = 0.0, tau_max = 0.0, q_standing = 0.0;
};

/// Joints in the order of the QP: SDK motors first, then further joints of the model.
using JointTable = std::vector<JointRow>;

/// Build the joint table of a robot. The limits of the twelve motors come from the configuration,
/// with the ranges of motion_range(); the limits of further joints come from the model.
JointTable make_joint_table(const Robot& robot);

}  // namespace surefoot
