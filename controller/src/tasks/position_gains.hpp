// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/gains.hpp"
#include "surefoot/math.hpp"

namespace surefoot {

/// Gains of the position task, world axes: horizontal gains in x and y, vertical gains in z. The
/// position is that of the centre of mass or of the base's origin.
struct PositionGains {
  explicit PositionGains(const Gains& g)
      : kp(g.com_kp_horizontal, g.com_kp_horizontal, g.com_kp_vertical),
        kd(g.com_kd_horizontal, g.com_kd_horizontal, g.com_kd_vertical),
        weight(g.weight_com_horizontal, g.weight_com_horizontal, g.weight_com_vertical) {}
  Vector3 kp, kd, weight;
};

}  // namespace surefoot
