// SPDX-License-Identifier: BSD-3-Clause
// Enters a mode, and moves the joint reference in that mode.
#include <cmath>

#include "supervisor/supervisor_impl.hpp"

namespace surefoot {

namespace {
// The constants are chosen by hand.
// [s] Time constant with which the joint reference comes to rest while JointImpedance fades out.
// Much shorter than TorqueFade::kTime.
constexpr double kRestTime = 0.03;
// [rad] 20 degrees: largest joint error from q_standing for which the robot counts as standing. If
// smaller: a robot whose pose a BodyReference has changed counts as sunk. If larger: a robot that
// has sunk counts as standing. kPathTolerance and kStandingTolerance have the same value.
constexpr double kUprightTolerance = 0.35;
}  // namespace

void Supervisor::Impl::enter_mode(Mode mode) noexcept {
  if (mode == Mode::kWalk) return start_walk();
  if (context.mode == Mode::kWalk || is_stepping()) return stop_stepping(mode);
  if (mode == Mode::kRise) {
    start_rise();
    motors.reset();
    fade.start(TorqueSource::kImpedance);
  } else if (mode == Mode::kSit && context.mode == Mode::kStand) {
    start_sitting();
  } else {
    if (mode == Mode::kStand) rise_abandoned = false;
    motion.go_to(mode == Mode::kSit ? 0.0 : 1.0);
  }
  // A request to stand while the robot sits down starts a rise from the present path position.
  context.mode = mode == Mode::kStand ? Mode::kRise : mode;
}

void Supervisor::Impl::start_sitting() noexcept {
  // A robot may have sunk while the motors damped, and then have been armed again. It must not rise
  // before it sits down, so the motion starts at the path position nearest to the present joints.
  const Vector12& q = impedance.q();
  const bool upright = (q - plan.joints_at(1.0)).cwiseAbs().maxCoeff() < kUprightTolerance;
  motion.start(upright ? 1.0 : plan.nearest(q), q);
  motion.go_to(0.0);
  fade.start(TorqueSource::kImpedance);
  context.mode = Mode::kSit;
}

void Supervisor::Impl::step_motion(const LowState& state, double dt) noexcept {
  const std::array<float, 3> w = state.imu.gyroscope;  // the field is packed, so it is copied
  const bool is_lying = context.mode == Mode::kRise && !is_raising_body();
  impedance.reduce_damping(is_lying ? Vector3(w[0], w[1], w[2]).norm() : 0.0, dt);
  if (context.mode == Mode::kRise) rise(state, dt);
  if (context.mode == Mode::kSit) sit(dt);
  // The impedance fades out, so its reference comes to a stop.
  if (context.mode == Mode::kPassive) {
    reference.dq *= std::exp(-dt / kRestTime);
    reference.q += dt * reference.dq;
  }
}

void Supervisor::Impl::sit(double dt) noexcept {
  if (is_raising_body()) reference = motion.step(impedance.q(), dt);
  if (!is_raising_body() || motion.arrived()) enter_passive();
}

// Enter the mode passive, and fade to damping. The robot lies or is nearly down.
void Supervisor::Impl::enter_passive() noexcept {
  context.mode = Mode::kPassive;
  // The robot lies now. Even if it was taken over standing, without checks, it must pass the arming
  // checks before it rises.
  context.checks_waived = false;
  // No estimator runs while the robot lies, so nothing shows whether a fault that the estimator
  // found has ended. The operator must arm again.
  if (estimator_faults.must_sit_down()) context.armed = false;
  log.set(FaultId::kHanging, false);
  fade.start(TorqueSource::kDamping);
  if (controller.lost_leg() >= 0) latch(FaultId::kLegLost);  // the robot cannot rise on three legs
}

}  // namespace surefoot
