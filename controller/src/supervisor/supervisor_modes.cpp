// SPDX-License-Identifier: BSD-3-Clause
// How modes are entered, and what moves in them.
#include <cmath>

#include "supervisor/supervisor_impl.hpp"

namespace surefoot {

namespace {
constexpr double kComeToRest = 0.03;  // [s]
constexpr double kUpright = 0.35;     // [rad] that joints may be off the end of the way up
}  // namespace

void Supervisor::Impl::enter(Mode mode) noexcept {
  if (mode == Mode::kRise) {
    start_rise();
    motors.reset();
    fade.to(Source::kSprings);
  } else if (mode == Mode::kSit && now.mode == Mode::kStand) {
    // Who was armed again where it had sunk is not to come up first.
    const Vector12& q = springs.q();
    const bool upright = (q - plan.joints_at(1.0)).cwiseAbs().maxCoeff() < kUpright;
    motion.start(upright ? 1.0 : plan.nearest(q), q);
    motion.go_to(0.0);
    fade.to(Source::kSprings);
  } else {
    if (mode == Mode::kStand) gave_up = false;
    motion.go_to(mode == Mode::kSit ? 0.0 : 1.0);
  }
  // Standing is asked for on the way down: that is a rise from where it is.
  now.mode = mode == Mode::kStand ? Mode::kRise : mode;
}

void Supervisor::Impl::move(const LowState& state, double dt) noexcept {
  const std::array<float, 3> w = state.imu.gyroscope;  // packed: copied
  const bool lies = now.mode == Mode::kRise && !upward();
  springs.give_way(lies ? Vector3(w[0], w[1], w[2]).norm() : 0.0, dt);
  if (now.mode == Mode::kRise) rise(state, dt);
  if (now.mode == Mode::kSit) sit(dt);
  // Springs that only fade out come to rest.
  if (now.mode == Mode::kPassive) {
    reference.dq *= std::exp(-dt / kComeToRest);
    reference.q += dt * reference.dq;
  }
}

void Supervisor::Impl::sit(double dt) noexcept {
  if (upward()) reference = motion.step(springs.q(), dt);
  if (!upward() || motion.arrived()) lie();
}

// On the ground, or as good as: the motors' own damping takes over.
void Supervisor::Impl::lie() noexcept {
  now.mode = Mode::kPassive;
  now.trusted = false;  // the one that was taken over as it stood: it lies now, and must be armed
  // Nothing tells a robot that lies whether what its estimator found is over: the operator must.
  if (sensors.sits_down()) now.armed = false;
  log.set(FaultId::kHanging, false);
  fade.to(Source::kDamping);
  if (stand.lost_leg() >= 0) latch(FaultId::kLegLost);  // three legs do not rise
}

}  // namespace surefoot
