// SPDX-License-Identifier: BSD-3-Clause
#include "supervisor/supervisor_impl.hpp"

#include <cmath>

#include "safety/torque_command.hpp"
#include "surefoot/wireless_remote.hpp"

namespace surefoot {

namespace {

constexpr double kPlannedShare = 0.5;  // of the power level: what the plan takes
constexpr double kLimitedShare = 0.8;  // of the power level: what the springs may take ...
constexpr double kStandShare = 0.9;    // ... and a StandController, by the joints' speeds reported
constexpr Button kStopButton = Button::kB;

double watts(const SupervisorOptions& options) {
  options.validate();
  return Safety::kWattsPerLevel * std::max(options.power_level, 1);
}

// What leaves is limited first; the protection has the last word.
StandOptions within_power(const SupervisorOptions& options) {
  StandOptions stand = options.stand;
  if (options.power_level > 0) {
    stand.power_limit = std::min(stand.power_limit, kStandShare * watts(options));
  }
  return stand;
}

}  // namespace

Supervisor::Impl::Impl(const Robot& r, const Gains& gains, const SupervisorOptions& o)
    : robot(r),
      options(o),
      plan(plan_rise(r, kPlannedShare * watts(o))),
      arming(r, {o.arming_time, o.temperature_warning, o.joint_margin, plan.torque_share}),
      folding(plan, gains.fold_wait),
      weighing(plan),
      pressing(plan),
      motion(plan),
      springs(r, plan, kLimitedShare * watts(o)),
      stand(r, gains, within_power(o)),
      safety(r),
      motors(r, o.temperature_warning, o.temperature_stop, o.joint_margin),
      sensors(o.payload_limit),
      rate(r.config().tau_max),
      damping_kd(gains.damping_kd) {
  now.trusted = o.start == Start::kStanding;
  publish();
}

// Read, judge, obey, move, command: every tick the same way.
const LowCmd& Supervisor::Impl::tick(const LowState& state) noexcept {
  const double step = clock.advance(state.tick);
  const double dt = step > 0.0 ? std::min(step, TickClock::kMaxStep) : clock.period();
  const bool good = read(state, step, dt);
  log.set(FaultId::kLink, false);
  log.set(FaultId::kStop, requests.take_stop());
  const bool pressed = decode_wireless_remote(state.wirelessRemote).pressed(kStopButton);
  log.set(FaultId::kButton, pressed && options.remote);
  if (good) judge(state, dt);
  react();
  if (good) {
    obey(requests.take());
    if (now.trusted && now.mode == Mode::kPassive && !now.armed) take_over();
    move(state, dt);
  }
  const LowCmd* out = nullptr;
  if (!drives()) {
    rate.rest(damping_kd);
    out = &keeper.accept(damping_low_cmd(damping_kd));
  } else if (good) {
    out = &command(state, dt);
  } else {
    out = &keeper.refuse(dt, damping_kd);
    motors.interrupted();
    if (keeper.latched() || clock.gap() > kAwayTime) latch(bad);
  }
  if (good) motors.sent(*out, state);
  const bool program = good && fade.needs(Source::kProgram);
  fresh = good && (!program || is_fresh(stand.rung()));
  const bool bridged = stand.rung() != Rung::kSolved && stand.rung() != Rung::kDamping;
  log.set(FaultId::kProgram, program && bridged);
  publish();
  return *out;
}

// Judged again: since another thread asked, the robot has gone on.
void Supervisor::Impl::obey(int request) noexcept {
  if (request == Requests::kArm) {
    if (judge_arming(now) != RequestStatus::kAccepted) return;
    const bool take = now.trusted && now.mode == Mode::kDamping;
    now.mode = Mode::kPassive;
    now.armed = true;
    keeper.reset();
    pace = {};  // at rest it goes on saying what it said last
    for (const FaultId over :
         {FaultId::kController, FaultId::kWiring, FaultId::kWrongRobot, FaultId::kLegLost}) {
      log.set(over, false);  // it begins anew
    }
    reason = FaultId::kNone;
    if (take) {
      take_over();
    } else {
      stand.reset();  // all four legs are its own again
    }
  } else if (request != Requests::kNothing) {
    const Mode mode = static_cast<Mode>(request);
    if (judge_request(now, mode) == RequestStatus::kAccepted) enter(mode);
  }
}

// A robot that stands by itself would sink in any fade.
void Supervisor::Impl::take_over() noexcept {
  stand.reset();
  motors.reset();
  now.mode = Mode::kStand;
  now.armed = true;
  stage =
      RiseStage::kUp;  // or it would be thought to lie, and be let go of instead of sitting down
  motion.start(1.0, springs.q());
  rate.forget();
  fade.jump(Source::kProgram);
}

void Supervisor::Impl::latch(FaultId why) noexcept {
  requests.take();  // what was asked before is void
  if (now.mode == Mode::kDamping) return;
  now.mode = Mode::kDamping;
  now.armed = now.ready = false;
  arming.distrust();  // what it was before it was let go of says nothing: the second begins anew
  fade.jump(Source::kDamping);
  rate.rest(damping_kd);
  unsolved = held_back = {};
  log.set(FaultId::kTorqueRate, false);
  log.set(FaultId::kHanging, false);  // seen on the way up, which is over: it must not bar the next
  reason = why;
}

void Supervisor::Impl::publish() noexcept {
  now.fading = fade.moving();
  requests.publish(now);
  report.write(arming.report());
  faults.write(log.report());
  shown_stage = stage;
  const bool on_the_way = active() && upward();
  height = on_the_way ? motion.position() : 0.0;
}

}  // namespace surefoot
