// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dynamics/dynamics.hpp"
#include "surefoot/types.hpp"
#include "tasks/body_rows.hpp"

namespace surefoot {

/// Axes and weights of the position task when a push will move the capture point across a support
/// edge.
///
/// The QP brakes motion across that edge first, and uses the remaining force to brake motion along
/// it. Motors and friction often cannot do both, because each newton along the edge reduces the
/// force available across it. Example: a push at 22.5 deg from forward crosses the front edge. If
/// the QP also brakes sideways, one front leg carries most of the weight, and the other front leg
/// has no load and no friction. The support extends further along the edge than across it, so
/// motion along the edge can be braked later.
///
/// Each edge k has a proximity p_k = max(1 - margin_k / 3 cm, 0): 0 inside, 1 at the edge, above 1
/// outside. The edge with the largest proximity p_max defines the axes: `across` is its outward
/// normal, `along` its direction. The closer p_max is to 1, the smaller is the weight along this
/// edge. Every other edge k, with normal n_k, raises this weight again, by the share
/// |n_k . along| p_k / p_max. So near a corner the QP brakes across both edges.
struct EdgeBrakingAxes {
  Matrix3 R = Matrix3::Identity();  ///< rows: edge normal (outward), along the edge, up; world axes
  double along = 1.0;               ///< factor on the weight of the row along the edge, 0.01 .. 1

  /// Rotate the rows of the position task into these axes, and multiply the weight of the row along
  /// the edge by the factor.
  /// Real-time: yes.
  void apply_to(BodyRows& position) const noexcept;
};

/// Compute the axes from the capture point that is predicted if f_external acts for another 0.08 s.
/// Return world axes and factor 1 if this point is at least 3 cm inside all edges, if there are
/// fewer than three stance feet, or if the robot steps. Real-time: yes.
/// @param mass mass of the robot [kg]
EdgeBrakingAxes edge_braking_axes(const Dynamics& dynamics, const RobotState& state,
                                  const Reference& reference, double mass) noexcept;

}  // namespace surefoot
