// SPDX-License-Identifier: BSD-3-Clause
#include "gait/foothold.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace surefoot {

namespace {

// [h] Largest distance of a foothold from its hip at touchdown. Chosen: the reach of the legs at
// the standing height.
constexpr double kMaxOffset = 0.83;
// [h] Smallest distance of a planned foothold from the middle of the body, to its own side: 8 cm at
// h = 0.3 m. Chosen: with less, the left and the right leg touch in a walk to the side. What brakes
// a push may be nearer.
constexpr double kMinSide = 0.27;
// [h] Smallest distance of a foothold from the foot across, to its own side: 6 cm at h = 0.3 m.
// Chosen: with less, the calves of the left and the right leg touch.
constexpr double kMinGap = 0.2;
// [g] Limit of late changes of a foothold: the change that is still allowed, made at once, adds
// this acceleration to the swing. Spread over the swing it adds up to three times as much, because
// its last parts have less time. Chosen: a little more than a steady swing at 1.5 m/s needs. Of 3,
// 6, 8 and 12, robots with random commands and pushes fell most often with 3; without a limit they
// fell more often than with any.
constexpr double kLateChange = 8.0;

// Return the planned place of a foot at touchdown, from the centre of mass, in axes of the heading
// at mid-stance.
// @param travel of the body from touchdown on, mean of the stance [m], the same axes
Eigen::Vector2d planned_place(const GaitSize& size, int leg,
                              const Eigen::Vector2d& travel) noexcept {
  Eigen::Vector2d place = size.nominal_feet.col(leg).head<2>() + travel;
  const double side = size.nominal_feet(1, leg) < 0.0 ? -1.0 : 1.0;
  place.y() = side * std::max(side * place.y(), kMinSide * size.height);
  return place;
}

// Return the mean distance, over the stance, of the body from where it was at touchdown [m].
Eigen::Vector2d mean_travel(const BodyTrajectory& body, double time_left,
                            double stance_time) noexcept {
  const VelocityChange& change = body.change();
  const Eigen::Vector2d moved =
      (change.moved_integral(time_left + stance_time) - change.moved_integral(time_left)) /
      stance_time;
  return 0.5 * stance_time * body.v_world() + moved - change.moved(time_left);
}

// Return the mean distance, over the stance, of the zero-moment point from the centre of mass [m].
// While the body accelerates with a, it is a h / g behind it.
Eigen::Vector2d mean_zmp_offset(const GaitSize& size, const BodyTrajectory& body, double time_left,
                                double stance_time) noexcept {
  const VelocityChange& change = body.change();
  const Eigen::Vector2d a_mean =
      (change.gained(time_left + stance_time) - change.gained(time_left)) / stance_time;
  const Eigen::Vector2d a_curve = body.a_world() - change.a;
  return -size.time * size.time * (a_mean + a_curve);
}

}  // namespace

Eigen::Vector2d foothold(const Gains& gains, const GaitSize& size, const HorizontalMotion& measured,
                         const BodyTrajectory& body, int leg, double time_left,
                         double stance_time) noexcept {
  const double turn = body.velocity().yaw_rate * (time_left + 0.5 * stance_time);
  const Eigen::Rotation2Dd R(body.yaw() + turn);
  const Eigen::Vector2d hip = measured.p_com + time_left * measured.v_com +
                              body.change().moved(time_left) +
                              R * Eigen::Vector2d(size.nominal_feet.col(leg).head<2>());
  const Eigen::Vector2d travel = R.inverse() * mean_travel(body, time_left, stance_time);
  const Eigen::Vector2d planned =
      R * Eigen::Vector2d(planned_place(size, leg, travel) - size.nominal_feet.col(leg).head<2>());
  Eigen::Vector2d offset = planned + mean_zmp_offset(size, body, time_left, stance_time) +
                           gains.foothold_feedback * size.time * (measured.v_com - body.v_world());
  offset *= std::min(1.0, kMaxOffset * size.height / std::max(offset.norm(), 1e-9));
  return hip + offset;
}

Eigen::Vector2d within_reach(const Eigen::Vector2d& last, const Eigen::Vector2d& foothold,
                             double time_left, double dt) noexcept {
  // Largest acceleration of a minimum-jerk motion over d in T: 10 / sqrt(3) d / T^2. So the
  // foothold may still move by d = sqrt(3) / 10 a T^2, and its speed is the derivative by T.
  const double speed = 0.2 * std::sqrt(3.0) * kLateChange * kGravity * time_left;
  const Eigen::Vector2d change = foothold - last;
  return last + std::min(1.0, speed * dt / std::max(change.norm(), 1e-12)) * change;
}

Eigen::Vector2d keep_apart(const GaitSize& size, double yaw, int leg,
                           const Eigen::Vector2d& foothold,
                           const Eigen::Vector2d& across) noexcept {
  const Eigen::Rotation2Dd R(yaw);
  const double side = size.nominal_feet(1, leg) < 0.0 ? -1.0 : 1.0;
  const double gap = side * (R.inverse() * (foothold - across)).y();
  const double lack = std::max(kMinGap * size.height - gap, 0.0);
  return foothold + R * Eigen::Vector2d(0.0, side * lack);
}

}  // namespace surefoot
