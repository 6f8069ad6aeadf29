// SPDX-License-Identifier: BSD-3-Clause
#include "surefoot/walk_controller.hpp"

#include "common/text.hpp"
#include "gait/trot_load.hpp"
#include "gait/walk_planner.hpp"
#include "surefoot/error.hpp"

namespace surefoot {

namespace {

const WalkOptions& validated(const WalkOptions& options) {
  options.validate();
  return options;
}

const Robot& checked(const Robot& robot) {
  const TrotLoad load = trot_load(robot);
  if (load.share <= kMaxTrotLoad) return robot;
  const RobotConfig& config = robot.config();
  throw Error("robot '" + config.name + "' cannot walk: on two feet " +
              config.joint_names[load.motor] + " needs " +
              to_text(load.share * config.tau_max[load.motor]) + " N.m, expected at most " +
              to_text(kMaxTrotLoad * config.tau_max[load.motor]) +
              " N.m, 0.8 of its limit; use a StandController");
}

}  // namespace

void WalkOptions::validate() const {
  tick.validate();
  if (velocity_timeout >= 0.01 && velocity_timeout <= 60.0) return;
  throw Error("option 'velocity_timeout' out of range: got " + to_text(velocity_timeout) +
              ", expected 0.01 .. 60 s");
}

WalkController::WalkController(const Robot& robot) : WalkController(robot, robot.config().gains) {}
WalkController::WalkController(const Robot& robot, const Gains& gains, const WalkOptions& options)
    : WalkController(Unchecked(), checked(robot), gains, options) {}
WalkController::WalkController(Unchecked, const Robot& robot, const Gains& gains,
                               const WalkOptions& options)
    : StandController(robot,
                      std::make_shared<WalkPlanner>(robot, validated(options).velocity_timeout,
                                                    options.tick.power_limit),
                      gains, options.tick) {}
WalkController::~WalkController() = default;
WalkController::WalkController(WalkController&&) noexcept = default;

void WalkController::set_velocity(const WalkVelocity& velocity) noexcept {
  planner().set_velocity(active_gains(), velocity);
}
WalkVelocity WalkController::commanded_velocity() const noexcept {
  return planner().command().velocity();
}
WalkVelocity WalkController::reference_velocity() const noexcept {
  return walking() ? planner().stepping().body().velocity() : WalkVelocity();
}
WalkLimit WalkController::velocity_limit() const noexcept { return planner().command().limit(); }

void WalkController::set_gait(Gait gait) noexcept { planner().set_gait(active_gains(), gait); }
Gait WalkController::gait() const noexcept { return planner().gait(); }
bool WalkController::walking() const noexcept {
  return planner().walking() && status() != Status::kDamping;
}
bool WalkController::velocity_expired() const noexcept { return planner().command().has_expired(); }
bool WalkController::can_walk() const noexcept { return planner().can_walk(); }
FeetMatrix WalkController::footholds() const noexcept { return planner().stepping().footholds(); }
Eigen::Vector4d WalkController::planned_loads() const noexcept {
  if (!walking()) return Eigen::Vector4d::Ones();
  Eigen::Vector4d loads;
  for (int leg = 0; leg < kLegs; ++leg) loads[leg] = planner().stepping().contacts().load(leg);
  return loads;
}

}  // namespace surefoot
