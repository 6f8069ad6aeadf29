// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/robot.hpp"

namespace surefoot {

/// Units and scales of the QP's variables and rows, computed from the robot in its standing pose.
/// They make the entries of the QP of order one for a robot of any size.
struct QpUnits {
  /// Throw surefoot::Error if a leg is singular in the standing pose.
  explicit QpUnits(const Robot& robot);
  double force = 1.0;    ///< [N] a quarter of the weight
  double length = 1.0;   ///< [m] mean depth of the feet below their hip axes
  double linear = 1.0;   ///< [m/s^2] linear acceleration of base and feet: g
  double angular = 1.0;  ///< [rad/s^2] angular acceleration of base and joints: g / length
  // Factors that bring the rows of the body tasks to length one in the standing pose.
  double scale_com = 1.0, scale_base = 1.0, scale_angular = 1.0, scale_momentum = 1.0;
  double smallest_determinant = 0.0;  ///< [m^3] a leg with a smaller |det J| is not inverted
};

}  // namespace surefoot
