// SPDX-License-Identifier: BSD-3-Clause
#include "gait/walk_recovery.hpp"

#include "reference/support_polygon.hpp"

namespace surefoot {

namespace {

// [h] Distance of the capture point from the planned one below which the robot is calm: 4.5 cm at
// h = 0.3 m. It walks again after a period of the trot. Chosen: above the error of a trot that is
// not pushed, up to 0.13 h. With 0.1, a go1 that turned went on trotting for 4 s after a push.
constexpr double kCalmDistance = 0.15;

bool is_inside(const FootContacts& contacts, const FeetMatrix& p_feet,
               const Eigen::Vector2d& p) noexcept {
  std::array<bool, kLegs> stance;
  for (int leg = 0; leg < kLegs; ++leg) stance[leg] = contacts.in_stance(leg);
  const SupportPolygon polygon(p_feet, stance);
  return polygon.is_valid() && polygon.margin(p) >= 0.0;
}

}  // namespace

bool WalkRecovery::update(const PlannerInput& input, const StepSchedule& schedule,
                          const HorizontalMotion& measured, const BodyTrajectory& body,
                          const BodySway& sway) noexcept {
  const Eigen::Vector2d error =
      measured.p_com - body.motion().p_com + size_.time * (measured.v_com - body.v_world());
  const bool calm = error.norm() <= kCalmDistance * size_.height;
  calm_time_ = calm ? calm_time_ + input.dt : 0.0;
  const Eigen::Vector2d planned_zmp =
      body.motion().p_com + sway.p() - size_.time * size_.time * (body.a_world() + sway.a());
  // All feet stand before a walk begins. So a trot that brakes a push goes on until the error is
  // small.
  const bool walks = schedule.pattern().walk;
  const bool can_brake = walks && is_inside(schedule.contacts(), input.p_feet, planned_zmp + error);
  trots_ |= !calm && !can_brake;
  trots_ = trots_ && calm_time_ < schedule.clock().timing().period;
  return trots_;
}

}  // namespace surefoot
