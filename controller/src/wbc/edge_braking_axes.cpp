// SPDX-License-Identifier: BSD-3-Clause
#include "wbc/edge_braking_axes.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "reference/capture_margin.hpp"

namespace surefoot {

namespace {

// The constants are chosen by hand. For pushes at 22.5 degrees from forward or backward, these axes
// raised the survival rate of go1 and go2 by 5 percentage points (`surefoot assess`). Tests:
// test_edge_braking_axes.cpp.
//
// [s] Time for which the external force is expected to continue. If shorter: the prediction misses
// pushes that cross an edge. If longer: the prediction exceeds the push; a standard push lasts
// 0.1 s and is partly over when it is detected.
constexpr double kRemainingPushTime = 0.08;
// [m] Distance of the capture point inside an edge at which its proximity begins to rise from 0.
constexpr double kEdgeRange = 0.03;
// Smallest factor on the weight along the edge. Above zero, so that the body does not drift along
// the edge.
constexpr double kMinAlongShare = 0.01;

}  // namespace

void EdgeBrakingAxes::apply_to(BodyRows& position) const noexcept {
  if (along == 1.0) return;
  position.A_base = (R * position.A_base).eval();
  position.A_force = (R * position.A_force).eval();
  position.b = (R * position.b).eval();
  position.weight[1] *= along;
}

EdgeBrakingAxes edge_braking_axes(const Dynamics& dynamics, const RobotState& state,
                                  const Reference& reference, double mass) noexcept {
  EdgeBrakingAxes axes;
  if (reference.stepping) return axes;  // the next step brakes
  const SupportPolygon polygon = support_polygon(dynamics, reference);
  const Eigen::Vector2d capture =
      capture_point(dynamics, kRemainingPushTime / mass * state.f_external);
  std::array<double, kLegs> edge_proximity = {};  // 0: inside, 1: at the edge, above 1: outside
  int worst = 0;
  for (int k = 0; k < polygon.edge_count(); ++k) {
    edge_proximity[k] = std::max(1.0 - polygon.edge(k, capture).margin / kEdgeRange, 0.0);
    if (edge_proximity[k] > edge_proximity[worst]) worst = k;
  }
  if (!(edge_proximity[worst] > 0.0)) return axes;
  const Eigen::Vector2d across = polygon.edge(worst, capture).outward;
  const Eigen::Vector2d along(-across.y(), across.x());
  double other_edges_share =
      0.0;  // 0 .. 1: how much the other edges require braking along the worst edge
  for (int k = 0; k < polygon.edge_count(); ++k) {
    if (k == worst) continue;
    const double part = std::abs(polygon.edge(k, capture).outward.dot(along));
    other_edges_share =
        std::max(other_edges_share, part * edge_proximity[k] / edge_proximity[worst]);
  }
  axes.R.row(0) << across.x(), across.y(), 0.0;
  axes.R.row(1) << along.x(), along.y(), 0.0;
  axes.along = 1.0 - std::min(edge_proximity[worst], 1.0) * (1.0 - kMinAlongShare) *
                         (1.0 - other_edges_share);
  return axes;
}

}  // namespace surefoot
