// SPDX-License-Identifier: BSD-3-Clause
#include "tick/planned_reference.hpp"

#include "dynamics/dynamics.hpp"
#include "robot/joint_table.hpp"
#include "surefoot/error.hpp"
#include "surefoot/stage_clock.hpp"
#include "wbc/input_check.hpp"

namespace surefoot {

namespace {

std::shared_ptr<Planner> require_planner(std::shared_ptr<Planner> planner) {
  if (planner) return planner;
  throw Error("Controller: got no planner, expected an object of a class derived from Planner");
}

Reference make_initial_reference(const Robot& robot) {
  Reference reference;
  reference.posture = Eigen::VectorXd::Zero(robot.nv() - 6);
  for (const JointRow& joint : make_joint_table(robot)) {
    reference.posture[joint.v - 6] = joint.q_standing;
  }
  return reference;
}

// Plan no load for the foot of a lost leg, and its measured motion as desired motion. With any
// other desired motion the QP would plan to accelerate the lost leg, for example to get a reaction
// force on the trunk. But the leg has no torque, so this force would not exist.
void release_foot(const LegDynamics& leg, FootReference& foot) noexcept {
  foot.stance = false;
  foot.load = 0.0;
  foot.p_world = leg.p_world_contact;
  foot.v_world = leg.v_world_contact;
  foot.a_world.setZero();
}

}  // namespace

PlannedReference::PlannedReference(const Robot& robot, std::shared_ptr<Planner> planner)
    : robot_(robot),
      planner_(require_planner(std::move(planner))),
      initial_(make_initial_reference(robot)),
      planned_(initial_),
      reference_(initial_) {}

Status PlannedReference::plan(const PlannerInput& input) noexcept {
  const StageScope stage(Stage::kReference);
  add_to_feet(-added_);
  const bool done = planner_->plan(input, planned_);
  if (input.lost_leg >= 0) {
    release_foot(input.dynamics.legs()[input.lost_leg], planned_.feet[input.lost_leg]);
  }
  if (!done || check_reference(planned_, robot_) != Status::kOk) {
    planned_ = reference_;
    return Status::kBadReference;
  }
  reference_ = planned_;
  has_reference_ = true;
  return Status::kOk;
}

void PlannedReference::add_to_feet(const FeetMatrix& a) noexcept {
  for (int leg = 0; leg < kLegs; ++leg) reference_.feet[leg].a_world += a.col(leg);
  added_ += a;
}

void PlannedReference::reset() noexcept {
  planner_->reset();
  added_.setZero();
  planned_ = reference_ = initial_;
  has_reference_ = false;
}

}  // namespace surefoot
