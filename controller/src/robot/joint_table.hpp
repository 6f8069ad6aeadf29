// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surefoot/robot.hpp"

namespace surefoot {

/// One joint of the QP: its indices and its limits in SI units.
struct JointRow {
  int v = 0;       ///< index of its velocity in v
  int q = -1;      ///< index of its angle in q; -1: the joint has no single angle
  int motor = -1;  ///< SDK number of its motor, or -1 for a further joint
  int group = 0;   ///< leg 0 .. 3, or 4 for a further joint
  /// Limits [rad], [rad/s], [N.m], and the angle in the standing pose [rad].
  double q_lower = 0.0, q_upper = 0.0, dq_max = 0.0, tau_max = 0.0, q_standing = 0.0;
};

/// Joints in the order of the QP: SDK motors first, then further joints of the model.
using JointTable = std::vector<JointRow>;

/// Build the joint table of a robot. The limits of the twelve motors come from the configuration,
/// with angle ranges from motion_range(). The limits of further joints come from the model.
JointTable make_joint_table(const Robot& robot);

}  // namespace surefoot
