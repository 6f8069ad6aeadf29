// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dynamics/dynamics.hpp"
#include "surefoot/gains.hpp"
#include "surefoot/types.hpp"
#include "wbc/condensation.hpp"

namespace surefoot {

/// Three rows of the cost: A f = b is wanted, and missed as cheaply as `weight` says.
///
/// f: contact forces [N], FR FL RR RL, world axes. b: an acceleration [m/s^2] or [rad/s^2].
struct TaskRows {
  Eigen::Matrix<double, 3, 12> A;
  Vector3 b;
  Vector3 weight;
};

}  // namespace surefoot
