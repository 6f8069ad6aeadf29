// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dynamics/dynamics.hpp"
#include "surefoot/types.hpp"
#include "tasks/body_rows.hpp"

namespace surefoot {

/// How a body that a push takes over an edge is braked: across that edge first, along it with what
/// is left.
///
/// Motors and friction that cannot give all of both give less across the edge for every newton
/// along it: a push at 22.5 deg from forward leaves over the front edge, and while it is also
/// braked sideways one front leg bears most of the weight and the other, unloaded, has no friction
/// to brake with. What the body gains along the edge meanwhile has room, and is braked afterwards.
/// At a corner both directions are edges and count alike; elsewhere each counts by how far the
/// capture point is over it.
struct BrakingAxes {
  Matrix3 R = Matrix3::Identity();  ///< rows: across the edge outward, along it, up; world axes
  double along = 1.0;               ///< share of the weight that braking along the edge keeps

  /// Turn the rows of the body's position into these axes, and weigh them so. Real-time: yes.
  void apply_to(BodyRows& position) const noexcept;
};

/// @param mass [kg] of the robot; its f_external is expected to last. Real-time: yes.
BrakingAxes braking_axes(const Dynamics& dynamics, const RobotState& state,
                         const Reference& reference, double mass) noexcept;

}  // namespace surefoot
