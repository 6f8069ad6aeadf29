// SPDX-License-Identifier: BSD-3-Clause
#include "gait/stepping.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "gait/foothold.hpp"
#include "gait/gait_timing.hpp"
#include "gait/step_timing.hpp"
#include "gait/sway_input.hpp"
#include "reference/capture_margin.hpp"

namespace surefoot {

namespace {

// [sqrt(g h)] Speed at which a foot reaches down that should have landed: 0.4 m/s at h = 0.3 m.
// Chosen: about twice the default of swing_landing_speed.
constexpr double kReachDownSpeed = 0.23;
// [h] Depth below the ground plane at which it stops: 9 cm at h = 0.3 m. Chosen: a little deeper
// than the highest step that the robot climbs.
constexpr double kReachDepth = 0.3;
// [period] Longest wait for late feet. Chosen: a foot that meets no ground within this time, 60 ms
// of a period of 0.42 s, has stepped into a hole.
constexpr double kMaxWait = 0.15;
// [sqrt(g h)] Velocity error below which a robot is not recovering from a push. Chosen: twice the
// velocity RMSE of a walk at 1.5 m/s.
constexpr double kSteadySpeed = 0.12;
// is_at_rest(): largest distance of a foot from its nominal position [h], 1.3 cm at h = 0.3 m, and
// largest speed of the body [sqrt(g h)], 5 cm/s. Chosen: the stand then needs no recovery step.
constexpr double kStopDistance = 0.045;
constexpr double kStopSpeed = 0.03;
// [walk_gait_speed] Speed below which a trot may change to a walk. Chosen: a little above the
// greatest speed of a walk.
constexpr double kWalkSpeed = 1.1;

HorizontalMotion measured_motion(const PlannerInput& input) noexcept {
  const Matrix3& R = input.R_world_base;
  return {input.p_com.head<2>(), input.v_com.head<2>(), std::atan2(R(1, 0), R(0, 0))};
}

// Return a leg of the pair that shall step first: the capture point is then nearest to the line
// between the feet of the other pair.
int leg_to_swing(const PlannerInput& input) noexcept {
  const Eigen::Vector2d capture = capture_point(input.dynamics);
  const auto distance = [&](int a, int b) {
    const Eigen::Vector2d p = input.p_feet.col(a).head<2>();
    const Eigen::Vector2d line = (input.p_feet.col(b).head<2>() - p).normalized();
    const Eigen::Vector2d d = capture - p;
    return std::abs(line.x() * d.y() - line.y() * d.x());
  };
  return distance(FL_, RR_) < distance(FR_, RL_) ? FR_ : FL_;
}

}  // namespace

void Stepping::start(const PlannerInput& input, const Vector3& ground_normal, bool walk,
                     const WalkVelocity& command, double height_offset) noexcept {
  begin(input, ground_normal, height_offset);
  pattern_ = suitable_pattern(pattern_, input.gains, size_, walk, command);
  clock_.start();
}

void Stepping::start_recovery(const PlannerInput& input, const Vector3& ground_normal,
                              double height_offset) noexcept {
  begin(input, ground_normal, height_offset);
  pattern_.walk = false;
  clock_.start_swing(gait_timing(pattern_, input.gains, size_, {}), leg_to_swing(input));
}

void Stepping::begin(const PlannerInput& input, const Vector3& ground_normal,
                     double height_offset) noexcept {
  at_rest_ = changes_pattern_ = false;
  contacts_.start();
  stumble_.start();
  clearance_.start();
  ground_.start(input.p_feet, input.state.contact, ground_normal);
  sway_.start();
  const Eigen::Vector2d p = input.p_com.head<2>();
  body_.start(measured_motion(input), input.p_com.z() - ground_.height_at(p) - height_offset);
  footholds_ = input.p_feet;
}

void Stepping::plan(const PlannerInput& input, bool walk, const WalkVelocity& command,
                    const BodyMotion& offset, bool may_stop, Reference& reference) noexcept {
  const HorizontalMotion measured = motion_without_sway(input);
  at_rest_ = may_stop && (input.lost_leg >= 0 || is_at_rest(input, measured));
  const Eigen::Vector4d contact = judge_contacts(input);
  update_pattern(input.gains, walk, command);
  update_clock(input, measured);
  contacts_.update(clock_, contact, stumble_.lifting(), input.dt);
  update_ground(input);
  body_.update(input.gains, command, measured,
               acceleration_share(pattern_, input.gains, size_, command, body_.velocity()),
               input.dt);
  sway_.update(sway_input({pattern_, size_, clock_, contacts_, body_, footholds_}, input),
               input.dt);
  body_.write(ground_, sway_, offset, input.delay, reference);
  // For those who compare base and reference: the QP moves the centre of mass.
  reference.p_base = reference.p_com + input.state.q.head<3>() - input.p_com;
  reference.v_base = reference.v_com;
  reference.stepping = true;
  for (int leg = 0; leg < kLegs; ++leg) {
    plan_foot(leg, input, measured);
    write_foot(leg, input, reference.feet[leg]);
  }
}

HorizontalMotion Stepping::motion_without_sway(const PlannerInput& input) const noexcept {
  HorizontalMotion motion = measured_motion(input);
  motion.p_com -= sway_.p();
  motion.v_com -= sway_.v();
  return motion;
}

// Change the pattern when all feet stand. A trot becomes a walk only at a speed at which a walk can
// go on.
void Stepping::update_pattern(const Gains& gains, bool walk, const WalkVelocity& command) noexcept {
  const StepPattern pattern = suitable_pattern(pattern_, gains, size_, walk, command);
  const double limit = kWalkSpeed * gains.walk_gait_speed * size_.speed;
  changes_pattern_ = !(pattern == pattern_) && (!walk || body_.v_world().norm() <= limit);
  if (!changes_pattern_ || !contacts_.others_in_stance(-1)) return;
  pattern_ = pattern;
  changes_pattern_ = false;
  clock_.start();
}

void Stepping::update_clock(const PlannerInput& input, const HorizontalMotion& measured) noexcept {
  GaitTiming timing = gait_timing(pattern_, input.gains, size_, body_.velocity());
  timing.period *= swing_time_factor(size_, clock_, timing, input.p_feet, measured, body_);
  clock_.advance(timing, longest_wait(), at_rest_ || changes_pattern_, input.dt);
}

// Return whether no push is being braked. After a push feet lag behind their references and land
// early without an obstacle.
bool Stepping::is_steady(const PlannerInput& input) const noexcept {
  const Eigen::Vector2d error = motion_without_sway(input).v_com - body_.v_world();
  return error.norm() < kSteadySpeed * size_.speed;
}

// Return the contact confidences, but 0 of a foot that lifts over an obstacle and has not landed.
Eigen::Vector4d Stepping::judge_contacts(const PlannerInput& input) noexcept {
  Eigen::Vector4d contact = input.state.contact;
  const bool steady = is_steady(input);
  for (int leg = 0; leg < kLegs; ++leg) {
    const bool may_hit = steady || stumble_.lifting(leg);
    if (!may_hit || contacts_.phase(leg) != FootPhase::kSwing) {
      stumble_.end(leg);
      continue;
    }
    const Vector3 p = input.p_feet.col(leg);
    const SwingFoot foot{swings_[leg].p_world(),
                         swings_[leg].v_world(),
                         p,
                         input.v_feet.col(leg),
                         p.z() - ground_.height_at(p.head<2>()),
                         contact[leg]};
    const double judged = stumble_.update(leg, foot, clock_.swing_progress(leg), input.dt);
    if (stumble_.lifting(leg)) contact[leg] = judged;
    if (!stumble_.begins(leg)) continue;
    swings_[leg].lift_off(stumble_.p_start(leg));
    clearance_.stumble();
  }
  return contact;
}

double Stepping::longest_wait() const noexcept {
  if (stumble_.any()) return stumble_.longest_time();
  // A walk lifts a foot only when the other three carry their full load.
  return contacts_.late(clock_, pattern_.walk ? 1.0 : 0.0) ? kMaxWait * clock_.timing().period
                                                           : 0.0;
}

void Stepping::update_ground(const PlannerInput& input) noexcept {
  const bool steady = is_steady(input);
  for (int leg = 0; leg < kLegs; ++leg) {
    const Vector3 foot = input.p_feet.col(leg);
    if (steady && contacts_.landed(leg))
      clearance_.land(foot.z() - ground_.height_at(foot.head<2>()));
    if (contacts_.phase(leg) == FootPhase::kStance) ground_.stand_at(leg, foot);
  }
  clearance_.advance(size_.fastest_hip(body_.velocity()), input.dt);
  ground_.update(size_.time, input.p_com.head<2>(), input.dt);
}

void Stepping::plan_foot(int leg, const PlannerInput& input,
                         const HorizontalMotion& measured) noexcept {
  SwingTrajectory& swing = swings_[leg];
  if (contacts_.lifted_off(leg) || contacts_.lost(leg)) swing.lift_off(input.p_feet.col(leg));
  if (contacts_.phase(leg) == FootPhase::kLateSwing) {
    const double ground = ground_.height_at(swing.p_world().head<2>());
    swing.reach_down(kReachDownSpeed * size_.speed, ground - kReachDepth * size_.height, input.dt);
  }
  if (contacts_.phase(leg) != FootPhase::kSwing) return;
  const bool lifting = stumble_.lifting(leg);
  const double time_left = lifting ? stumble_.time_left(leg) : clock_.time_to_touchdown(leg);
  const Eigen::Vector2d xy =
      foothold(input.gains, size_, measured, body_, leg, time_left, clock_.timing().stance_time());
  footholds_.col(leg) << xy, ground_.height_at(xy);
  Vector3 target = footholds_.col(leg);
  if (lifting && stumble_.rises(leg)) target.head<2>() = stumble_.p_start(leg).head<2>();
  const double planned =
      pattern_.walk ? input.gains.walk_gait_swing_height : input.gains.swing_height;
  const double height = lifting ? stumble_.height() : planned * size_.height + clearance_.extra();
  swing.update({height, input.gains.swing_landing_speed * size_.speed}, target,
               lifting ? stumble_.progress(leg) : clock_.swing_progress(leg),
               lifting ? stumble_.time() : clock_.timing().swing_time(), time_left, input.dt);
}

void Stepping::write_foot(int leg, const PlannerInput& input, FootReference& foot) const noexcept {
  const FootPhase phase = contacts_.phase(leg);
  foot.stance = phase != FootPhase::kSwing;
  foot.load = contacts_.load(leg);
  foot.min_contact = 1.0;
  // A stance foot stays where it is. Its contact point moves as the foot rolls, so the measured
  // point is the reference.
  foot.p_world = input.p_feet.col(leg);
  foot.v_world.setZero();
  foot.a_world.setZero();
  if (contacts_.in_stance(leg)) return;
  const SwingTrajectory& swing = swings_[leg];
  const double ahead = input.delay;
  foot.p_world = swing.p_world() + ahead * (swing.v_world() + 0.5 * ahead * swing.a_world());
  foot.v_world = swing.v_world() + ahead * swing.a_world();
  foot.a_world = swing.a_world();
}

// The body is at rest, and all feet are near their nominal positions.
bool Stepping::is_at_rest(const PlannerInput& input,
                          const HorizontalMotion& measured) const noexcept {
  if (measured.v_com.norm() > kStopSpeed * size_.speed) return false;
  if (body_.velocity().yaw_rate != 0.0 || !body_.v_world().isZero()) return false;
  const Eigen::Rotation2Dd R(body_.yaw());
  for (int leg = 0; leg < kLegs; ++leg) {
    const Eigen::Vector2d nominal = size_.nominal_feet.col(leg).head<2>();
    const Eigen::Vector2d offset = input.p_feet.col(leg).head<2>() - measured.p_com - R * nominal;
    if (offset.norm() > kStopDistance * size_.height) return false;
  }
  return true;
}

}  // namespace surefoot
