// SPDX-License-Identifier: BSD-3-Clause
#include "gait/walk_planner.hpp"

#include <cmath>
#include <cstdlib>

#include "dynamics/dynamics.hpp"
#include "gait/foothold.hpp"

namespace surefoot {

namespace {

// Unit h: height of the centre of mass above the ground, standing pose.
constexpr double kSwingHeight = 0.2;        // [h] 6 cm at 0.3 m
constexpr double kSwingDepth = 0.033;       // [h] 1 cm
constexpr double kTouchdownSpeed = 0.12;    // [sqrt(g h)] 0.2 m/s
constexpr double kReachDownSpeed = 0.23;    // [sqrt(g h)] 0.4 m/s
constexpr double kMaxOffset = 0.83;         // [h] 25 cm
constexpr double kPeriod = 2.4;             // [sqrt(h / g)] 0.42 s

const char* env(const char* n){return std::getenv(n);}
double ev(const char* n,double d){return env(n)?atof(env(n)):d;}
double heading(const Matrix3& R) noexcept { return std::atan2(R(1, 0), R(0, 0)); }

}  // namespace

WalkPlanner::WalkPlanner(const Robot& robot) {
  Dynamics standing(robot);
  standing.update(robot.q_standing(), Eigen::VectorXd::Zero(robot.nv()), Vector3::UnitZ());
  nominal_feet_ = contact_points(standing).colwise() - standing.p_world_com();
  height_ = -nominal_feet_.row(2).mean();
  corner_ = robot.config().corner_speed[1];
  timing_.period = kPeriod * std::sqrt(height_ / kGravity);
}

void WalkPlanner::reset() noexcept { started_ = false; }

void WalkPlanner::start(const PlannerInput& input) noexcept {
  started_ = true;
  clock_.start();
  contacts_.start();
  body_.start(input.p_com, heading(input.R_world_base));
  landings_ = footholds_ = input.p_feet;
}

bool WalkPlanner::plan(const PlannerInput& input, Reference& reference) noexcept {
  if (!started_) start(input);
  const double speed = std::hypot(body_.v_world().norm(), 0.0) + std::abs(body_.velocity().yaw_rate)*nominal_feet_.col(0).head<2>().norm();
  static const double stride=ev("STRIDE",0.7), duty=ev("DUTY",0.52), P0=ev("PERIOD",2.4);
  static const double vk=ev("VK",1e3);
  const double vmax = vk*corner_*height_;
  const double ratio = std::max((vmax/std::max(speed,1e-3)+1.0)/1.875-1.0, 0.3);
  timing_.duty=std::min(duty, ratio/(1+ratio));
  timing_.period=std::min(P0*std::sqrt(height_/kGravity), stride*height_/std::max(speed,1e-3)/timing_.duty);
  clock_.advance(timing_, contacts_.late(), input.dt);
  contacts_.update(clock_, input.state.contact, input.dt);
  update_ground(input);
  body_.update(command_, height_, ground_, input.p_com, heading(input.R_world_base), input.dt);
  body_.write(reference);
  static const double dl=ev("DELAY",0.0);
  reference.p_com += dl*reference.v_com;
  reference.ground_normal = Vector3::UnitZ();
  reference.stepping = true;
  for (int leg = 0; leg < kLegs; ++leg) {
    plan_swing(leg, input);
    write_foot(leg, input, reference.feet[leg]);
  }
  return true;
}

void WalkPlanner::update_ground(const PlannerInput& input) noexcept {
  for (int leg = 0; leg < kLegs; ++leg) {
    if (contacts_.phase(leg) == FootPhase::kStance) landings_.col(leg) = input.p_feet.col(leg);
  }
  ground_ = landings_.row(2).mean();
}

void WalkPlanner::plan_swing(int leg, const PlannerInput& input) noexcept {
  const double speed_unit = std::sqrt(kGravity * height_);
  SwingTrajectory& swing = swings_[leg];
  if (contacts_.lifted_off(leg)) swing.lift_off(input.p_feet.col(leg));
  if (contacts_.phase(leg) == FootPhase::kLateSwing) {
    if (contacts_.lost(leg)) swing.lift_off(input.p_feet.col(leg));
    swing.reach_down(kReachDownSpeed * speed_unit, input.dt);
  }
  if (contacts_.phase(leg) != FootPhase::kSwing) return;
  const HorizontalMotion motion{input.p_com.head<2>(), input.v_com.head<2>(), body_.yaw(),
                                std::sqrt(height_ / kGravity)};
  footholds_.col(leg) << foothold(motion, nominal_feet_.col(leg).head<2>(), body_.v_world(),
                                  body_.velocity().yaw_rate, clock_.time_to_touchdown(leg),
                                  timing_.stance_time(), kMaxOffset * height_),
      ground_;
  static const double sh=ev("SWINGH",0.2);
  const SwingTrajectory::Shape shape{sh * height_, ev("DEPTH",0.0) * height_,
                                     ev("TDS",0.12) * speed_unit};
  swing.update(shape, footholds_.col(leg), clock_.swing_progress(leg), timing_.swing_time(),
               clock_.time_to_touchdown(leg) - ev("HEARLY",0.0)*timing_.swing_time(), input.dt);
}

void WalkPlanner::write_foot(int leg, const PlannerInput& input,
                             FootReference& foot) const noexcept {
  const SwingTrajectory& swing = swings_[leg];
  const FootPhase phase = contacts_.phase(leg);
  foot.stance = phase != FootPhase::kSwing;
  foot.load = contacts_.load(leg);
  foot.min_contact = 1.0;
  foot.a_world.setZero();
  foot.v_world.setZero();
  foot.p_world = input.p_feet.col(leg);  // a stance foot stays where it is
  if (phase == FootPhase::kLateSwing) {
    foot.p_world = swing.p_world();
    foot.v_world = swing.v_world();
  }
  if (phase == FootPhase::kSwing) {
    foot.p_world = swing.p_world();
    foot.v_world = swing.v_world();
    foot.a_world = swing.a_world();
    static const double dl=ev("DELAY",0.0);
    foot.p_world += dl*(foot.v_world + 0.5*dl*foot.a_world);
    foot.v_world += dl*foot.a_world;
  }
}

}  // namespace surefoot
