// SPDX-License-Identifier: BSD-3-Clause
#include "surefoot/stand_controller.hpp"

#include <cmath>

#include "gait/walk_planner.hpp"
#include "reference/capture_margin.hpp"
#include "tick/controller_access.hpp"

namespace surefoot {

StandController::StandController(const Robot& robot)
    : StandController(robot, robot.config().gains) {}
StandController::StandController(const Robot& robot, const Gains& gains,
                                 const ControllerOptions& options)
    : StandController(robot, std::make_shared<WalkPlanner>(robot), gains, options) {}
StandController::StandController(const Robot& robot, std::shared_ptr<WalkPlanner> planner,
                                 const Gains& gains, const ControllerOptions& options)
    : Controller(robot, planner, gains, options), planner_(std::move(planner)) {}
StandController::~StandController() = default;
StandController::StandController(StandController&&) noexcept = default;

void StandController::set_body_reference(const BodyReference& target) noexcept {
  planner_->stand().set_target(target);
}
BodyReference StandController::body_reference() const noexcept {
  return planner_->stand().motion().relative_pose();
}
ReachStatus StandController::reach() const noexcept { return planner_->stand().motion().status(); }

double StandController::capture_margin_without(int leg) const noexcept {
  if (leg < 0 || leg >= kLegs || !planner_->has_started()) return std::nan("");
  std::array<bool, kLegs> stance = {true, true, true, true};
  stance[leg] = false;
  if (lost_leg() >= 0) stance[lost_leg()] = false;
  return capture_margin(ControllerAccess::dynamics(*this), stance);
}

}  // namespace surefoot
