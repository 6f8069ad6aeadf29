// SPDX-License-Identifier: BSD-3-Clause
// The stages of a rise: what is looked at before the body leaves the ground, and the way up.
#include <algorithm>

#include "supervisor/motor_values.hpp"
#include "supervisor/supervisor_impl.hpp"

namespace surefoot {

namespace {
constexpr double kOffGround = 0.2;  // of the way: feet below the body, on level ground
constexpr double kOnTheWay = 0.35;  // [rad] that each joint may be off it
constexpr double kBorne = 0.35;     // of the weight that legs bear which stand on something

bool any(const std::array<bool, kLegs>& legs) noexcept {
  return std::any_of(legs.begin(), legs.end(), [](bool leg) { return leg; });
}
}  // namespace

// Who is on the way already, standing or crouching, goes on from there; anybody else folds first.
void Supervisor::Impl::start_rise() noexcept {
  const Vector12& q = springs.q();
  const double s = plan.nearest(q);
  const bool near = (q - plan.joints_at(s)).cwiseAbs().maxCoeff() < kOnTheWay;
  gave_up = false;
  if (s > kOffGround && near && springs.can_hold()) {
    stage = RiseStage::kUp;
    motion.start(s, q);
    motion.go_to(1.0);
    return;
  }
  stage = RiseStage::kHoldLegs;
  lift = {};
  reference.q = q;
  reference.dq.setZero();
}

void Supervisor::Impl::rise(const LowState& state, double dt) noexcept {
  const bool folded = stage == RiseStage::kWeigh || stage == RiseStage::kPress;
  if (folded && folding.rolls(reference, springs.up(), dt)) stage = RiseStage::kFold;
  switch (stage) {
    case RiseStage::kHoldLegs:
      return hold_legs(state, dt);
    case RiseStage::kFold:
      return fold(dt);
    case RiseStage::kWeigh:
      return weigh(state, dt);
    case RiseStage::kPress:
      return press(state, dt);
    case RiseStage::kUp:
      return go_up(state, dt);
  }
}

// Legs bear themselves before they move: those of a smaller robot than this one is taken for would
// be thrown about by its springs.
void Supervisor::Impl::hold_legs(const LowState& state, double dt) noexcept {
  lift.update(measured_torques(state), springs.in_air(), dt);
  if (!lift.done()) return;
  if (lift.too_light()) return refuse(FaultId::kWrongRobot, -1);
  stage = RiseStage::kFold;
  folding.start(springs.q(), springs.up());
}

void Supervisor::Impl::fold(double dt) noexcept {
  reference = folding.step(springs.q(), springs.up(), dt);
  if (folding.rolls_on()) {
    refuse(FaultId::kWiring, -1);
  } else if (folding.done()) {
    stage = RiseStage::kWeigh;
    weighing.start(reference.q, {true, true, true, true});
  } else if (const auto side = folding.folded_side(springs.q()); any(side)) {
    folding.side_weighed();
    stage = RiseStage::kWeigh;
    weighing.start(reference.q, side);
  } else if (folding.pinned(springs.q(), springs.up())) {
    refuse(FaultId::kWrongRobot, -1);
  } else if (folding.stuck()) {
    gave_up = true;
    lie();
  }
}

void Supervisor::Impl::weigh(const LowState& state, double dt) noexcept {
  reference = weighing.step(measured_torques(state), springs.in_air(), dt);
  switch (weighing.verdict()) {
    case LegWeighing::Verdict::kNone:
      return;
    case LegWeighing::Verdict::kWrongSide:
      return refuse(FaultId::kWiring, weighing.motor());
    case LegWeighing::Verdict::kWrongWeight:
      return refuse(FaultId::kWrongRobot, -1);
    case LegWeighing::Verdict::kFits:
      if (!folding.done()) {
        stage = RiseStage::kFold;
        return;
      }
      stage = RiseStage::kPress;
      return pressing.start(reference.q);
  }
}

void Supervisor::Impl::press(const LowState& state, double dt) noexcept {
  const double borne = springs.borne(measured_torques(state));
  reference = pressing.step(springs.R_world_base(), borne, dt);
  if (pressing.failed()) return refuse(FaultId::kWiring, pressing.motor());
  if (!pressing.passed()) return;
  stage = RiseStage::kUp;
  motion.start(0.0, reference.q);
  motion.go_to(1.0);
}

void Supervisor::Impl::go_up(const LowState& state, double dt) noexcept {
  reference = motion.step(springs.q(), dt);
  if (motion.stuck()) {
    gave_up = true;
    enter(Mode::kSit);
  } else if (motion.arrived() && springs.borne(measured_torques(state)) < kBorne) {
    log.set(FaultId::kHanging, true);
    enter(Mode::kSit);
  } else if (motion.arrived() && imu.accelerometer_bad()) {
    enter(Mode::kSit);  // an estimator has nothing to begin with
  } else if (motion.arrived()) {
    stand.reset();
    now.mode = Mode::kStand;
    fade.to(Source::kProgram);
  }
}

void Supervisor::Impl::refuse(FaultId why, int motor) noexcept {
  log.set(why, true, motor);
  latch(why);
}

}  // namespace surefoot
