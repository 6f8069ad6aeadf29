// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dynamics/dynamics.hpp"
#include "surefoot/gains.hpp"
#include "surefoot/types.hpp"

namespace surefoot {

using Matrix3x12 = Eigen::Matrix<double, 3, 3 * kLegs>;
using Matrix6x12 = Eigen::Matrix<double, 6, 3 * kLegs>;

/// Task of the body: three rows A_base a_b + A_force f = b. Both forms of the QP minimise
///   1/2 sum_i weight_i (scale (A_base a_b + A_force f - b)_i)^2
///
/// a_b: acceleration of the base, Pinocchio's local axes. f: contact forces [N], FR FL RR RL, world
/// axes. b: a linear acceleration [m/s^2], an angular acceleration [rad/s^2] or a moment [N.m].
struct BodyRows {
  Matrix36 A_base = Matrix36::Zero();
  Matrix3x12 A_force = Matrix3x12::Zero();
  Vector3 b = Vector3::Zero();
  Vector3 weight = Vector3::Zero();
  /// Brings the rows to length one, so that the weights of tasks are comparable.
  double scale = 1.0;
};

}  // namespace surefoot
