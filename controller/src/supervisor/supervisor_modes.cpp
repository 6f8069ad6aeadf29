// SPDX-License-Identifier: BSD-3-Clause
// How modes are entered, and what moves in them.
#include <cmath>

#include "supervisor/supervisor_impl.hpp"

namespace surefoot {

namespace {
constexpr double kComeToRest = 0.03;  // [s]
constexpr double kOffGround = 0.2;    // of the way: feet below the body, on level ground
constexpr double kOnTheWay = 0.35;    // [rad] that each joint may be off it
constexpr double kBorne = 0.35;       // of the weight that legs bear which stand on something
}  // namespace

void Supervisor::Impl::enter(Mode mode) noexcept {
  if (mode == Mode::kRise) {
    start_rise();
    safety.reset();
    motors.reset();
    fade.to(Source::kSprings);
  } else if (mode == Mode::kSit && now.mode == Mode::kStand) {
    motion.start(1.0, springs.q());
    motion.go_to(0.0);
    fade.to(Source::kSprings);
  } else {
    motion.go_to(mode == Mode::kSit ? 0.0 : 1.0);
  }
  // Standing is asked for on the way down: that is a rise from where it is.
  now.mode = mode == Mode::kStand ? Mode::kRise : mode;
}

// Who is on the way already, standing or crouching, goes on from there; anybody else folds first.
void Supervisor::Impl::start_rise() noexcept {
  const Vector12& q = springs.q();
  const double s = plan.nearest(q);
  const bool near = (q - plan.joints_at(s)).cwiseAbs().maxCoeff() < kOnTheWay;
  folded = s > kOffGround && near && springs.can_hold();
  gave_up = false;
  if (!folded) return folding.start(q);
  motion.start(s, q);
  motion.go_to(1.0);
}

void Supervisor::Impl::move(const LowState& state, double dt) noexcept {
  if (now.mode == Mode::kRise) rise(state, dt);
  if (now.mode == Mode::kSit) sit(dt);
  // Springs that only fade out come to rest.
  if (now.mode == Mode::kPassive) {
    reference.dq *= std::exp(-dt / kComeToRest);
    reference.q += dt * reference.dq;
  }
}

void Supervisor::Impl::rise(const LowState& state, double dt) noexcept {
  if (!folded) {
    reference = folding.step(springs.q(), dt);
    if (folding.done()) {
      folded = true;
      motion.start(0.0, reference.q);
      motion.go_to(1.0);
    } else if (folding.stuck()) {
      gave_up = true;
      lie();
    }
    return;
  }
  reference = motion.step(springs.q(), dt);
  if (motion.stuck()) {
    gave_up = true;
    enter(Mode::kSit);
  } else if (motion.arrived() && springs.borne(state) < kBorne) {
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

void Supervisor::Impl::sit(double dt) noexcept {
  if (folded) reference = motion.step(springs.q(), dt);
  if (!folded || motion.arrived()) lie();
}

// On the ground, or as good as: the motors' own damping takes over.
void Supervisor::Impl::lie() noexcept {
  now.mode = Mode::kPassive;
  log.set(FaultId::kHanging, false);
  fade.to(Source::kDamping);
}

}  // namespace surefoot
