// SPDX-License-Identifier: BSD-3-Clause
#include "replay_controller.hpp"

namespace bench {

using namespace surefoot;

ReplayController::ReplayController(const ReplayPlan& plan) : plan_(plan) {
  const ControllerOptions options{0.0, 0.0, plan.form};
  if (plan.velocities.empty()) {
    controller_ = std::make_unique<StandController>(plan.robot, plan.gains, options);
  } else {
    auto walk = std::make_unique<WalkController>(plan.robot, plan.gains, WalkOptions{options});
    walk_ = walk.get();
    controller_ = std::move(walk);
  }
  start();
}

void ReplayController::start() noexcept {
  controller_->reset();
  if (walk_ != nullptr) walk_->set_gait(plan_.gait);
}

void ReplayController::request(std::size_t tick) noexcept {
  if (!plan_.references.empty()) controller_->set_body_reference(plan_.references[tick]);
  if (walk_ != nullptr) walk_->set_velocity(plan_.velocities[tick]);
}

bool ReplayController::solved() const noexcept {
  return controller_->fallback_level() == FallbackLevel::kSolved;
}

}  // namespace bench
