// SPDX-License-Identifier: BSD-3-Clause
// Begins and ends walks. A robot whose feet step stops on four feet before it sits down.
#include "supervisor/supervisor_impl.hpp"

namespace surefoot {

namespace {
// [s] Time after which a robot that shall sit down does so, although it has not stopped. Chosen:
// longer than a stop from the largest velocity of a trot on flat ground. A b1 in a gait walk needs
// up to 1.7 s: its feet then stand already, but its body still sways.
constexpr double kStopTime = 1.5;
}  // namespace

void Supervisor::Impl::set_velocity(const WalkVelocity& velocity) noexcept {
  if (context.mode == Mode::kWalk && !context.stopping) controller.set_velocity(velocity);
}

void Supervisor::Impl::set_gait(Gait next) noexcept {
  gait = next;
  if (context.mode == Mode::kWalk && !context.stopping) controller.set_gait(gait);
}

void Supervisor::Impl::start_walk() noexcept {
  context.mode = Mode::kWalk;
  controller.set_gait(gait);
  controller.set_velocity({});  // expires if no velocity follows
}

// Begin to stop. step_walk() enters the mode `next`, kStand or kSit, when the robot has stopped.
void Supervisor::Impl::stop_stepping(Mode next) noexcept {
  if (context.stopping) {
    if (next != after_stop) stop_time = 0.0;  // the time until it sits counts from the request
    after_stop = next;
    return;
  }
  after_stop = next;
  context.stopping = true;
  stop_time = 0.0;
  if (controller.gait() == Gait::kTrot) controller.set_gait(Gait::kAuto);  // a trot does not stop
  controller.set_velocity({});
}

void Supervisor::Impl::step_walk(double dt) noexcept {
  if (context.mode == Mode::kWalk && !context.stopping && controller.velocity_expired()) {
    stop_stepping(Mode::kStand);
  }
  if (!context.stopping) return;
  stop_time += dt;
  const bool sits_in_any_case = after_stop == Mode::kSit && stop_time > kStopTime;
  if (controller.reference().stepping && !sits_in_any_case) return;
  context.stopping = false;
  context.mode = Mode::kStand;
  if (after_stop == Mode::kSit) start_sitting();
}

}  // namespace surefoot
