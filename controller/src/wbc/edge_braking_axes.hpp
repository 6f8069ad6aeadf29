// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dynamics/dynamics.hpp"
#include "surefoot/types.hpp"
#include "tasks/body_rows.hpp"

namespace surefoot {

/// Axes and weights of the position task when a push will move the capture point across a support
/// edge.
///
/// The QP brakes motion normal to that edge first, and motion along it with the force that is left.
/// Motors and friction often cannot do both: each newton along the edge reduces the force across
/// it. Example: a push at 22.5 deg from forward crosses the front edge. If the QP also brakes it
/// sideways, one front leg carries most of the weight, and the other has no load and no friction.
/// Motion along the edge has room and can be braked later. At a corner both edges count. Elsewhere
/// each edge counts by how far the capture point is beyond it.
struct EdgeBrakingAxes {
  Matrix3 R = Matrix3::Identity();  ///< rows: edge normal (outward), along the edge, up; world axes
  double along = 1.0;               ///< weight factor of the row along the edge, 0.01 .. 1

  /// Rotate the rows of the position task into these axes, and scale their weights.
  /// Real-time: yes.
  void apply_to(BodyRows& position) const noexcept;
};

/// Compute the axes from the predicted capture point. The prediction assumes that f_external acts
/// for another 0.08 s. Returns world axes if the point is inside all edges by 3 cm or more, or if
/// fewer than three feet stand. Real-time: yes.
/// @param mass of the robot [kg]
EdgeBrakingAxes edge_braking_axes(const Dynamics& dynamics, const RobotState& state,
                                  const Reference& reference, double mass) noexcept;

}  // namespace surefoot
