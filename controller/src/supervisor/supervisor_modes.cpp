// SPDX-License-Identifier: BSD-3-Clause
// How modes are entered, and what moves in them.
#include <cmath>

#include "supervisor/supervisor_impl.hpp"

namespace surefoot {

namespace {
constexpr double kRestTime = 0.03;          // [s]
constexpr double kUprightTolerance = 0.35;  // [rad] that joints may be off the end of the way up
}  // namespace

void Supervisor::Impl::enter_mode(Mode mode) noexcept {
  if (mode == Mode::kRise) {
    start_rise();
    motors.reset();
    fade.start(TorqueSource::kImpedance);
  } else if (mode == Mode::kSit && context.mode == Mode::kStand) {
    // Who was armed again where it had sunk is not to come up first.
    const Vector12& q = impedance.q();
    const bool upright = (q - plan.joints_at(1.0)).cwiseAbs().maxCoeff() < kUprightTolerance;
    motion.start(upright ? 1.0 : plan.nearest(q), q);
    motion.go_to(0.0);
    fade.start(TorqueSource::kImpedance);
  } else {
    if (mode == Mode::kStand) gave_up = false;
    motion.go_to(mode == Mode::kSit ? 0.0 : 1.0);
  }
  // Standing is asked for on the way down: that is a rise from where it is.
  context.mode = mode == Mode::kStand ? Mode::kRise : mode;
}

void Supervisor::Impl::step_motion(const LowState& state, double dt) noexcept {
  const std::array<float, 3> w = state.imu.gyroscope;  // packed: copied
  const bool lies = context.mode == Mode::kRise && !is_raising_body();
  impedance.reduce_damping(lies ? Vector3(w[0], w[1], w[2]).norm() : 0.0, dt);
  if (context.mode == Mode::kRise) rise(state, dt);
  if (context.mode == Mode::kSit) sit(dt);
  // Springs that only fade out come to rest.
  if (context.mode == Mode::kPassive) {
    reference.dq *= std::exp(-dt / kRestTime);
    reference.q += dt * reference.dq;
  }
}

void Supervisor::Impl::sit(double dt) noexcept {
  if (is_raising_body()) reference = motion.step(impedance.q(), dt);
  if (!is_raising_body() || motion.arrived()) enter_passive();
}

// On the ground, or as good as: the motors' own damping takes over.
void Supervisor::Impl::enter_passive() noexcept {
  context.mode = Mode::kPassive;
  context.checks_waived =
      false;  // the one that was taken over as it stood: it lies now, and must be armed
  // Nothing tells a robot that lies whether what its estimator found is over: the operator must.
  if (estimator_faults.must_sit_down()) context.armed = false;
  log.set(FaultId::kHanging, false);
  fade.start(TorqueSource::kDamping);
  if (stand.lost_leg() >= 0) latch(FaultId::kLegLost);  // three legs do not rise
}

}  // namespace surefoot
