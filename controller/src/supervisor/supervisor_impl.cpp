// SPDX-License-Identifier: BSD-3-Clause
#include "supervisor/supervisor_impl.hpp"

#include <cmath>

#include "low_state_check.hpp"
#include "surefoot/wireless_remote.hpp"

namespace surefoot {

namespace {

constexpr double kPlannedShare = 0.5;  // of the power level: what the plan takes
constexpr double kLimitedShare = 0.8;  // of the power level: what the springs may take
constexpr double kFallTilt = 0.7;      // [rad] while rising and sitting
constexpr int kBadMotorReports = 3;
constexpr Button kStopButton = Button::kB;

double watts(const SupervisorOptions& options) {
  options.validate();
  return Safety::kWattsPerLevel * options.power_level;
}

}  // namespace

Supervisor::Impl::Impl(const Robot& r, const Gains& gains, const SupervisorOptions& o)
    : robot(r),
      options(o),
      plan(plan_rise(r, kPlannedShare * watts(o))),
      arming(r, {o.arming_time, o.temperature_warning, o.joint_margin, plan.torque_share}),
      folding(plan),
      motion(plan),
      springs(r, plan, kLimitedShare * watts(o)),
      stand(r, gains, o.stand),
      safety(r),
      damping_kd(gains.damping_kd) {
  publish();
}

// Read, judge, obey, move, command: every tick the same way.
const LowCmd& Supervisor::Impl::tick(const LowState& state) noexcept {
  const double step = clock.advance(state.tick);
  const double dt = step > 0.0 ? std::min(step, TickClock::kMaxStep) : clock.period();
  const bool good = read(state, step);
  if (requests.take_stop()) latch(DampingReason::kStop);
  if (decode_wireless_remote(state.wirelessRemote).pressed(kStopButton)) {
    latch(DampingReason::kButton);
  }
  if (good) {
    const DampingReason fault = active() ? find_fault(state) : DampingReason::kNone;
    if (fault != DampingReason::kNone) latch(fault);
    obey(requests.take());
    move(dt);
  }
  const LowCmd* out = nullptr;
  if (!active() && !fade.moving()) {
    out = &keeper.accept(damping_low_cmd(damping_kd));
  } else if (good) {
    out = &command(state, dt);
  } else {
    out = &keeper.refuse(dt, damping_kd);
    if (keeper.latched()) latch(DampingReason::kBadState);
  }
  publish();
  return *out;
}

bool Supervisor::Impl::read(const LowState& state, double step) noexcept {
  if (step < 0.0) {
    arming.missed();
    now.ready = false;
    return false;
  }
  arming.update(state, step);
  const bool good =
      check_low_state(state, robot.config()) == Status::kOk && has_quaternion(state.imu);
  if (good) {
    springs.read(state);
    now.seen = true;
  } else {
    arming.distrust();
  }
  now.ready = arming.report().ready;
  return good;
}

DampingReason Supervisor::Impl::find_fault(const LowState& state) noexcept {
  bool all_servo = true;
  for (int i = 0; i < kMotors; ++i) all_servo &= state.motorState[i].mode == kModeServo;
  bad_motors = all_servo ? 0 : bad_motors + 1;
  if (bad_motors >= kBadMotorReports) return DampingReason::kMotor;
  // The command is not read.
  if (safety.power_protect(LowCmd{}, state, options.power_level) < 0) return DampingReason::kPower;
  // While standing this is the controller's to judge, by its gain fall_tilt.
  const bool standing = now.mode == Mode::kStand;
  if (!standing && springs.cos_tilt() < std::cos(kFallTilt)) return DampingReason::kFallen;
  return DampingReason::kNone;
}

// Judged again: since another thread asked, the robot has gone on.
void Supervisor::Impl::obey(int request) noexcept {
  if (request == Requests::kArm) {
    if (judge_arming(now) != RequestStatus::kAccepted) return;
    now.mode = Mode::kPassive;
    now.armed = true;
    keeper.reset();
    reason = DampingReason::kNone;
  } else if (request != Requests::kNothing) {
    const Mode mode = static_cast<Mode>(request);
    if (judge_request(now, mode) == RequestStatus::kAccepted) enter(mode);
  }
}

void Supervisor::Impl::latch(DampingReason why) noexcept {
  if (now.mode == Mode::kDamping) return;
  now.mode = Mode::kDamping;
  now.armed = now.ready = false;
  arming.distrust();  // what it was before it was let go of says nothing: the second begins anew
  fade.jump(Source::kDamping);
  safety.reset();
  reason = why;
}

Drive Supervisor::Impl::drive(Source source, const LowState& state) noexcept {
  Drive out;
  if (source == Source::kDamping) out.kd = damping_kd;
  if (source == Source::kSprings) {
    out.tau = springs.torques(reference, folded ? motion.load() : 0.0);
    out.kd = springs.damping();
  }
  if (source != Source::kProgram) return out;
  const LowCmd& command = stand.update(state);
  for (int i = 0; i < kMotors; ++i) out.tau[i] = command.motorCmd[i].tau;
  out.kd = command.motorCmd[0].Kd;
  return out;
}

const LowCmd& Supervisor::Impl::command(const LowState& state, double dt) noexcept {
  fade.advance(dt);
  Drive drive = this->drive(fade.to(), state);
  if (fade.moving()) {
    const Drive before = this->drive(fade.from(), state);
    const double w = fade.weight();
    drive.tau = (1.0 - w) * before.tau + w * drive.tau;
    drive.kd = (1.0 - w) * before.kd + w * drive.kd;
  }
  if (fade.needs(Source::kProgram) && stand.status() == Status::kDamping) {
    latch(DampingReason::kController);
    return keeper.accept(damping_low_cmd(damping_kd));
  }
  LowCmd command = init_low_cmd();
  for (int i = 0; i < kMotors; ++i) {
    MotorCmd& motor = command.motorCmd[i];
    motor.tau = static_cast<float>(drive.tau[i]);
    if (drive.kd > 0.0) {
      motor.dq = 0.0F;
      motor.Kd = static_cast<float>(drive.kd);
    }
  }
  return keeper.accept(command);
}

void Supervisor::Impl::publish() noexcept {
  now.fading = fade.moving();
  requests.publish(now);
  report.write(arming.report());
  const bool on_the_way = active() && folded;
  height = on_the_way ? motion.position() : 0.0;
}

}  // namespace surefoot
