// SPDX-License-Identifier: BSD-3-Clause
#include "run/stand_loop.hpp"

#include <algorithm>
#include <cmath>

#include "surefoot/error.hpp"

namespace surefoot {

namespace {

constexpr std::uint64_t kConvinced = 10;  // datagrams of another generation

const RunOptions& checked(const RunOptions& options, const UdpLinkOptions& link) {
  options.validate();
  if (link.real_robot && options.start != Start::kLying) {
    throw Error(
        "a real robot: got start 'standing', expected 'lying': it is not moved but behind arming "
        "checks (surefoot run --rise --real-robot)");
  }
  return options;
}

SupervisorOptions supervised(const RunOptions& options, const StandOptions& stand) {
  SupervisorOptions out;
  out.power_level = options.power_level;
  out.start = options.start;
  out.remote = options.remote;
  out.operator_timeout = options.operator_timeout;
  out.stand = stand;
  return out;
}

}  // namespace

StandLoop::StandLoop(const Robot& robot, const Gains& gains, const StandOptions& stand,
                     const UdpLinkOptions& link, const RunOptions& options)
    : options_(checked(options, link)),
      supervisor_(robot, gains, supervised(options, stand)),
      link_(link),
      tau_max_(robot.config().tau_max),
      damping_(damping_low_cmd(gains.damping_kd)),
      log_(static_cast<std::size_t>(std::ceil(options.log_time * options.rate))) {}

void StandLoop::tick(double time, double elapsed) noexcept {
  now_.time = time;
  obey_letters();
  const bool newer = link_.receive();
  if (stop_.load()) end(RunReason::kAsked);
  // Damped for something before, and asked for now: this is how it was wanted.
  if (damp_.exchange(false) && now_.phase == RunPhase::kDamping) now_.reason = RunReason::kAsked;
  if (ended()) {
    send(damping_, newer);
  } else if (link_.known()) {
    supervise(newer, elapsed);
  } else {
    wait_for_robot();
  }
  const bool over = counts_from_ >= 0.0 && time - counts_from_ > options_.duration;
  if (over) finish();
  if (finish_.load() && !ended()) sit_down_and_end();
}

void StandLoop::wait_for_robot() noexcept {
  send_damping();
  if (link_.counts().wrong_generation >= kConvinced) {
    end(RunReason::kWrongGeneration);
  } else if (now_.time > options_.patience) {
    end(RunReason::kNoState);
  }
}

void StandLoop::supervise(bool newer, double elapsed) noexcept {
  now_.ticks += now_.phase != RunPhase::kDamping;
  count_reports();
  if (elapsed > kAwayTime) {
    if (supervisor_.armed()) now_.gap = elapsed;
    lose(RunReason::kAway);
  }
  if (link_.counts().restarts != restarts_) lose(RunReason::kRestart);
  const double age = link_.age();
  if (silent_ && newer && age < kStaleTime) forgive_or_lose();
  send(newer && age < kHoldTime ? control(link_.state()) : bridge(age, elapsed), newer);
  watch();
}

void StandLoop::send(const LowCmd& command, bool heard) noexcept {
  link_.send(command);
  log(command, heard);
}

// The supervisor gets the newest report of a tick; the link heard them all.
void StandLoop::count_reports() noexcept {
  const LinkCounts& counts = link_.counts();
  supervisor_.count_reports(static_cast<double>(counts.valid - valid_),
                            static_cast<double>(counts.lost) - static_cast<double>(missing_));
  valid_ = counts.valid;
  missing_ = counts.lost;
}

const LowCmd& StandLoop::control(const LowState& state) noexcept {
  silence_.heard(now_.time, state.tick);
  if (options_.remote) obey_sticks();
  const LowCmd& command = supervisor_.update(state);
  const StandController& controller = supervisor_.stand();
  now_.status = controller.status();
  now_.fault = controller.fault();
  if (now_.phase != RunPhase::kDamping) {
    const bool standing = supervisor_.mode() == Mode::kStand;
    now_.usable += supervisor_.fresh();
    now_.saturated += standing && now_.status == Status::kSaturated;
    now_.greatest_power = std::max(now_.greatest_power, supervisor_.power());
  }
  now_.power = supervisor_.power();
  return command;
}

// No new report: the command before, then damping, then that for good.
const LowCmd& StandLoop::bridge(double age, double elapsed) noexcept {
  now_.bridged += now_.phase != RunPhase::kDamping;
  const LowCmd& command = supervisor_.bridge(age);
  if (silent_ && !silence_.forgivable(now_.time)) lose(RunReason::kStale);
  if (!silent_ && supervisor_.armed() && silence_.is_stale(age, elapsed, 1.0 / options_.rate)) {
    silent_ = true;
    now_.gap = age;
  }
  return command;
}

// The robot is heard again.
void StandLoop::forgive_or_lose() noexcept {
  if (supervisor_.armed() && silence_.stood_still(now_.time, link_.state().tick)) {
    silent_ = false;
    ++now_.pauses;
  } else {
    lose(RunReason::kStale);
  }
}

void StandLoop::lose(RunReason why) noexcept {
  lost_ = why;
  silent_ = false;
  restarts_ = link_.counts().restarts;
  supervisor_.lose();
}

void StandLoop::sit_down_and_end() noexcept {
  const Mode mode = now_.mode;
  const bool up = mode == Mode::kRise || mode == Mode::kStand || mode == Mode::kSit;
  if (options_.start == Start::kStanding || now_.phase == RunPhase::kDamping ||
      (!up && !supervisor_.fading())) {
    end(RunReason::kAsked);
  } else if (mode == Mode::kRise || mode == Mode::kStand) {
    supervisor_.request(Mode::kSit);  // refused while torques fade: the next tick asks again
  }
}

void StandLoop::end(RunReason why) noexcept {
  // What it ended for counts, unless it was damping for something before; and with no robot it has
  // controlled nothing, whoever asked for the end.
  if (now_.phase == RunPhase::kWaiting && why == RunReason::kAsked) why = RunReason::kNoState;
  if (now_.phase != RunPhase::kDamping) now_.reason = why;
  const bool lies = now_.mode == Mode::kPassive || now_.mode == Mode::kDamping;
  const bool there = lies || options_.start == Start::kStanding;
  now_.stood_to_end = why == RunReason::kAsked && in_order_ && there && !silent_;
  now_.phase = RunPhase::kEnded;
  news_ = true;
}

}  // namespace surefoot
