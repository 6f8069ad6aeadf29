// SPDX-License-Identifier: BSD-3-Clause
#include "gait/foothold.hpp"

#include <Eigen/Geometry>
#include <algorithm>

namespace surefoot {

namespace {

// [h] Largest distance of a foothold from its hip at touchdown. Chosen: the reach of the legs at
// the standing height.
constexpr double kMaxOffset = 0.83;

}  // namespace

Eigen::Vector2d foothold(const Gains& gains, const GaitSize& size, const HorizontalMotion& measured,
                         const BodyTrajectory& body, int leg, double time_left,
                         double stance_time) noexcept {
  const double turn = body.velocity().yaw_rate * (time_left + 0.5 * stance_time);
  const Eigen::Vector2d hip =
      measured.p_com + time_left * measured.v_com +
      Eigen::Rotation2Dd(body.yaw() + turn) * Eigen::Vector2d(size.nominal_feet.col(leg).head<2>());
  // While the body accelerates with a, the zero-moment point is a h / g behind the centre of mass.
  Eigen::Vector2d offset = 0.5 * stance_time * body.v_world() +
                           gains.foothold_feedback * size.time * (measured.v_com - body.v_world()) -
                           size.time * size.time * body.a_world();
  offset *= std::min(1.0, kMaxOffset * size.height / std::max(offset.norm(), 1e-9));
  return hip + offset;
}

}  // namespace surefoot
