// SPDX-License-Identifier: BSD-3-Clause
#include "gait/swing_feet.hpp"

#include "gait/foothold.hpp"

namespace surefoot {

namespace {

// [sqrt(g h)] Speed at which a foot reaches down that should have landed: 0.4 m/s at h = 0.3 m.
// Chosen: about twice the default of swing_landing_speed.
constexpr double kReachDownSpeed = 0.23;
// [h] Depth below the ground plane at which it stops: 9 cm at h = 0.3 m. Chosen: a little deeper
// than the highest step that the robot climbs.
constexpr double kReachDepth = 0.3;

}  // namespace

void SwingFeet::start(const FeetMatrix& p_world_feet) noexcept {
  stumble_.start();
  clearance_.start();
  footholds_ = p_world_feet;
}

Eigen::Vector4d SwingFeet::judge_contacts(const PlannerInput& input, const StepSchedule& schedule,
                                          const GroundPlane& ground, bool steady) noexcept {
  Eigen::Vector4d contact = input.state.contact;
  for (int leg = 0; leg < kLegs; ++leg) {
    const bool may_hit = steady || stumble_.lifting(leg);
    if (!may_hit || schedule.contacts().phase(leg) != FootPhase::kSwing) {
      stumble_.end(leg);
      continue;
    }
    const Vector3 p = input.p_feet.col(leg);
    const SwingFoot foot{swings_[leg].p_world(),
                         swings_[leg].v_world(),
                         p,
                         input.v_feet.col(leg),
                         p.z() - ground.height_at(p.head<2>()),
                         contact[leg]};
    const double progress = schedule.clock().swing_progress(leg);
    const double judged = stumble_.update(leg, foot, progress, input.dt);
    if (stumble_.lifting(leg)) contact[leg] = judged;
    if (!stumble_.begins(leg)) continue;
    swings_[leg].lift_off(stumble_.p_start(leg));
    clearance_.stumble();
  }
  return contact;
}

void SwingFeet::update_clearance(const PlannerInput& input, const FootContacts& contacts,
                                 const GroundPlane& ground, bool steady, double speed) noexcept {
  for (int leg = 0; leg < kLegs; ++leg) {
    if (!steady || !contacts.landed(leg)) continue;
    const Vector3 foot = input.p_feet.col(leg);
    clearance_.land(foot.z() - ground.height_at(foot.head<2>()));
  }
  clearance_.advance(speed, input.dt);
}

Eigen::Vector2d SwingFeet::foot_across(int leg, const PlannerInput& input,
                                       const FootContacts& contacts) const noexcept {
  const int across = leg ^ 1;  // FR FL RR RL
  const bool stands = contacts.phase(across) == FootPhase::kStance;
  return (stands ? input.p_feet : footholds_).col(across).head<2>();
}

void SwingFeet::plan(int leg, const PlannerInput& input, const StepSchedule& schedule,
                     const HorizontalMotion& measured, const BodyTrajectory& body,
                     const GroundPlane& ground, bool steady) noexcept {
  const FootContacts& contacts = schedule.contacts();
  const GaitClock& clock = schedule.clock();
  const bool begins = contacts.lifted_off(leg) || contacts.lost(leg);
  if (begins) swings_[leg].lift_off(input.p_feet.col(leg));
  if (contacts.phase(leg) == FootPhase::kLateTouchdown) {
    const double lowest =
        ground.height_at(swings_[leg].p_world().head<2>()) - kReachDepth * size_.height;
    swings_[leg].reach_down(kReachDownSpeed * size_.speed, lowest, input.dt);
  }
  if (contacts.phase(leg) != FootPhase::kSwing) return;
  const double time_left =
      stumble_.lifting(leg) ? stumble_.time_left(leg) : clock.time_to_touchdown(leg);
  Eigen::Vector2d xy =
      foothold(input.gains, size_, measured, body, leg, time_left, clock.timing().stance_time());
  if (steady) xy = keep_apart(size_, body.yaw(), leg, xy, foot_across(leg, input, contacts));
  if (!begins) xy = within_reach(footholds_.col(leg).head<2>(), xy, time_left, input.dt);
  footholds_.col(leg) << xy, ground.height_at(xy);
  swing(leg, input, schedule, time_left);
}

void SwingFeet::swing(int leg, const PlannerInput& input, const StepSchedule& schedule,
                      double time_left) noexcept {
  const Gains& gains = input.gains;
  const GaitClock& clock = schedule.clock();
  const bool lifting = stumble_.lifting(leg);
  Vector3 target = footholds_.col(leg);
  if (lifting && stumble_.rises(leg)) target.head<2>() = stumble_.p_start(leg).head<2>();
  const double planned =
      schedule.pattern().walk ? gains.walk_gait_swing_height : gains.swing_height;
  const double height = lifting ? stumble_.height() : planned * size_.height + clearance_.extra();
  swings_[leg].update({height, gains.swing_landing_speed * size_.speed}, target,
                      lifting ? stumble_.progress(leg) : clock.swing_progress(leg),
                      lifting ? stumble_.time() : clock.timing().swing_time(), time_left, input.dt);
}

void SwingFeet::write(int leg, const PlannerInput& input, const FootContacts& contacts,
                      FootReference& foot) const noexcept {
  foot.stance = contacts.phase(leg) != FootPhase::kSwing;
  foot.load = contacts.load(leg);
  foot.min_contact = 1.0;
  // A stance foot stays where it is. Its contact point moves as the foot rolls, so the measured
  // point is the reference.
  foot.p_world = input.p_feet.col(leg);
  foot.v_world.setZero();
  foot.a_world.setZero();
  if (contacts.in_stance(leg)) return;
  const SwingTrajectory& swing = swings_[leg];
  const double ahead = input.delay;
  foot.p_world = swing.p_world() + ahead * (swing.v_world() + 0.5 * ahead * swing.a_world());
  foot.v_world = swing.v_world() + ahead * swing.a_world();
  foot.a_world = swing.a_world();
}

}  // namespace surefoot
