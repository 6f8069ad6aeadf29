// SPDX-License-Identifier: BSD-3-Clause
// Runs the stages of a rise: first folding and checks while the body lies on the ground, then
// raising the body.
#include <algorithm>

#include "supervisor/common/motor_measurements.hpp"
#include "supervisor/supervisor_impl.hpp"

namespace surefoot {

namespace {
// The constants are chosen by hand.
// Smallest path parameter s from which a rise may start without folding. On level ground the feet
// are below the body from this s on.
constexpr double kMinStartPosition = 0.2;
// [rad] 20 degrees: largest distance of a joint from the path for such a start.
constexpr double kPathTolerance = 0.35;
// Share of the weight on the legs below which the robot hangs. Chosen between a hanging robot (0)
// and a robot on its feet (1). The row hanging and every rise of `surefoot faults` bracket the
// value.
constexpr double kMinLoadShare = 0.35;

bool any(const std::array<bool, kLegs>& legs) noexcept {
  return std::any_of(legs.begin(), legs.end(), [](bool leg) { return leg; });
}
}  // namespace

// Start a rise. If the joints are near the planned path at s > kMinStartPosition, the robot
// continues from there. Otherwise it folds its legs first.
void Supervisor::Impl::start_rise() noexcept {
  const Vector12& q = impedance.q();
  const double s = plan.nearest(q);
  const bool near_path = (q - plan.joints_at(s)).cwiseAbs().maxCoeff() < kPathTolerance;
  rise_abandoned = false;
  if (s > kMinStartPosition && near_path && impedance.can_hold()) {
    stage = RiseStage::kUp;
    motion.start(s, q);
    motion.go_to(1.0);
    return;
  }
  stage = RiseStage::kHoldLegs;
  light_leg_check = {};
  reference.q = q;
  reference.dq.setZero();
}

void Supervisor::Impl::rise(const LowState& state, double dt) noexcept {
  const bool folded = stage == RiseStage::kWeigh || stage == RiseStage::kPress;
  if (folded && folding.detect_rollover(reference, impedance.up(), dt)) stage = RiseStage::kFold;
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
      return raise_body(state, dt);
  }
}

// Apply the gravity torques of the model's legs, and check the measured torques before the legs
// move. If the model is that of a larger robot, the joint impedance for the large legs would throw
// the legs of the smaller robot.
void Supervisor::Impl::hold_legs(const LowState& state, double dt) noexcept {
  light_leg_check.update(measured_torques(state), impedance.leg_gravity_torques(), dt);
  if (!light_leg_check.done()) return;
  if (light_leg_check.too_light()) return abort_rise(FaultId::kWrongRobot, -1);
  stage = RiseStage::kFold;
  folding.start(impedance.q(), impedance.up());
}

void Supervisor::Impl::fold(double dt) noexcept {
  reference = folding.step(impedance.q(), impedance.up(), dt);
  if (folding.rolled_over()) {
    abort_rise(FaultId::kWiring, -1);
  } else if (folding.done()) {
    stage = RiseStage::kWeigh;
    weight_check.start(reference.q, {true, true, true, true});
  } else if (const auto side = folding.folded_side(impedance.q()); any(side)) {
    folding.side_weighed();
    stage = RiseStage::kWeigh;
    weight_check.start(reference.q, side);
  } else if (folding.pinned(impedance.q(), impedance.up())) {
    abort_rise(FaultId::kWrongRobot, -1);
  } else if (folding.stuck()) {
    rise_abandoned = true;
    enter_passive();
  }
}

void Supervisor::Impl::weigh(const LowState& state, double dt) noexcept {
  reference = weight_check.step(measured_torques(state), impedance.leg_gravity_torques(), dt);
  switch (weight_check.verdict()) {
    case LegWeightCheck::Verdict::kNone:
      return;
    case LegWeightCheck::Verdict::kWrongSide:
      return abort_rise(FaultId::kWiring, weight_check.motor());
    case LegWeightCheck::Verdict::kWrongWeight:
      return abort_rise(FaultId::kWrongRobot, -1);
    case LegWeightCheck::Verdict::kFits:
      if (!folding.done()) {
        stage = RiseStage::kFold;
        return;
      }
      stage = RiseStage::kPress;
      return press_check.start(reference.q);
  }
}

void Supervisor::Impl::press(const LowState& state, double dt) noexcept {
  const double load = impedance.load_share(measured_torques(state));
  reference = press_check.step(impedance.R_world_base(), load, dt);
  if (press_check.failed()) return abort_rise(FaultId::kWiring, press_check.motor());
  if (!press_check.passed()) return;
  stage = RiseStage::kUp;
  motion.start(0.0, reference.q);
  motion.go_to(1.0);
}

void Supervisor::Impl::raise_body(const LowState& state, double dt) noexcept {
  reference = motion.step(impedance.q(), dt);
  if (motion.stuck()) {
    rise_abandoned = true;
    enter_mode(Mode::kSit);
  } else if (motion.arrived() && impedance.load_share(measured_torques(state)) < kMinLoadShare) {
    log.set(FaultId::kHanging, true);
    enter_mode(Mode::kSit);
  } else if (motion.arrived() && imu.accelerometer_bad()) {
    enter_mode(Mode::kSit);  // the estimator cannot start without an accelerometer
  } else if (motion.arrived()) {
    controller.reset();
    context.mode = Mode::kStand;
    fade.start(TorqueSource::kController);
  }
}

void Supervisor::Impl::abort_rise(FaultId why, int motor) noexcept {
  log.set(why, true, motor);
  latch(why);
}

}  // namespace surefoot
