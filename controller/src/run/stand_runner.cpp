// SPDX-License-Identifier: BSD-3-Clause
#include "surefoot/stand_runner.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "clock.hpp"
#include "run/latency_histogram.hpp"
#include "run/real_time.hpp"
#include "run/remote_reference.hpp"
#include "run/run_board.hpp"
#include "safety/command_keeper.hpp"
#include "surefoot/safety.hpp"

namespace surefoot {

namespace {

constexpr double kFarewell = 0.2;         // [s] of damping frames at the end: UDP may lose some
constexpr double kPublishing = 0.05;      // [s] between looks from outside
constexpr std::uint64_t kConvinced = 10;  // datagrams of another generation
// [s] to listen before a silence counts: a machine that stood still held the robot's side up too.
constexpr double kListening = 0.007;

}  // namespace

struct StandRunner::Impl {
  Impl(const Robot& robot, const Gains& gains, const StandOptions& stand,
       const UdpLinkOptions& link_options, const RunOptions& o)
      : options((o.validate(), o)),
        controller(robot, gains, stand),
        safety(robot),
        link(link_options),
        damping(damping_low_cmd(gains.damping_kd)) {}
  void tick(double elapsed) noexcept;
  void wait_for_robot() noexcept;
  void stand(bool newer, double elapsed) noexcept;
  void control(const LowState& state) noexcept;
  void bridge(double age, double elapsed) noexcept;
  void obey_remote() noexcept;
  void latch(RunReason why) noexcept;
  void begin() noexcept;
  void end(RunReason why) noexcept;
  const RunSnapshot& describe() noexcept;

  RunOptions options;
  StandController controller;
  Safety safety;
  UdpLink link;
  LowCmd damping, last = damping;
  LatencyHistogram ticks, wakes;
  RunSnapshot now;  // the loop's own
  double start = 0.0, begun = 0.0, published = 0.0;
  double listened = 0.0;       // [s] without a report, in which this program ran
  std::uint64_t restarts = 0;  // of the robot, when control began
  std::atomic<bool> stop{false}, damp{false}, rearm{false};
  RunBoard board;
};

void StandRunner::run() {
  Impl& s = *impl_;
  const RealTimeScope scope;
  s.board.set_real_time(scope.scheduling() + ", " + scope.memory());
  PeriodicTimer timer(1.0 / s.options.rate);
  s.start = monotonic_time();
  while (s.now.phase != RunPhase::kEnded) {
    s.wakes.add(timer.wait());
    const double woken = monotonic_time();
    const double elapsed = woken - s.start - s.now.time;
    s.now.time = woken - s.start;
    s.tick(elapsed);
    s.ticks.add(1e6 * (monotonic_time() - woken));
    s.now.missed = static_cast<std::uint64_t>(timer.missed());
    if (s.now.time - s.published > kPublishing) {
      s.published = s.now.time;
      s.board.publish(s.describe(), s.ticks, s.wakes);
    }
  }
  for (double t = 0.0; t < kFarewell; t += 1.0 / s.options.rate) {
    s.link.send(s.damping);
    timer.wait();
  }
  s.board.publish_last(s.describe(), s.ticks, s.wakes);
}

// elapsed: [s] since the tick before.
void StandRunner::Impl::tick(double elapsed) noexcept {
  const bool newer = link.receive();
  if (stop.load()) end(RunReason::kAsked);
  const bool damped = damp.exchange(false);
  const bool rearmed = rearm.exchange(false) && !damped;
  if (damped) latch(RunReason::kAsked);
  switch (now.phase) {
    case RunPhase::kWaiting:
      wait_for_robot();
      break;
    case RunPhase::kStanding:
      stand(newer, elapsed);
      break;
    case RunPhase::kDamping:
      link.send(damping);
      if (rearmed && link.age() < kStaleTime) {
        ++now.rearms;
        begin();
      } else if (rearmed) {
        ++now.refused_rearms;
      }
      break;
    case RunPhase::kEnded:
      link.send(damping);
      break;
  }
  if (now.ticks > 0 && now.time - begun > options.duration) end(RunReason::kAsked);
}

void StandRunner::Impl::wait_for_robot() noexcept {
  link.send(damping);
  if (link.known()) {
    begun = now.time;
    begin();
  } else if (link.counts().wrong_generation >= kConvinced) {
    end(RunReason::kWrongGeneration);
  } else if (now.time > options.patience) {
    end(RunReason::kNoState);
  }
}

void StandRunner::Impl::begin() noexcept {
  controller.reset();
  safety.reset();
  last = damping;
  listened = 0.0;
  restarts = link.counts().restarts;
  now.phase = RunPhase::kStanding;
}

void StandRunner::Impl::stand(bool newer, double elapsed) noexcept {
  ++now.ticks;
  if (elapsed > kAwayTime) {
    now.gap = elapsed;
    latch(RunReason::kAway);
  }
  if (link.counts().restarts != restarts) latch(RunReason::kRestart);
  const double age = link.age();
  if (newer && age < kHoldTime) {
    listened = 0.0;
    control(link.state());
  } else {
    bridge(age, elapsed);
  }
  link.send(now.phase == RunPhase::kStanding ? last : damping);
}

void StandRunner::Impl::control(const LowState& state) noexcept {
  if (options.remote) obey_remote();
  last = controller.update(state);
  now.status = controller.status();
  now.fault = controller.fault();
  now.usable += is_usable(now.status);
  now.saturated += now.status == Status::kSaturated;
  if (options.power_level > 0) {
    const bool tripped = safety.power_protect(last, state, options.power_level) < 0;
    now.power = safety.power();
    now.greatest_power = std::max(now.greatest_power, now.power);
    if (tripped) latch(RunReason::kPowerProtect);
  }
  if (now.status == Status::kDamping) latch(RunReason::kController);
}

// No new report: the command before, then damping, then that for good.
void StandRunner::Impl::bridge(double age, double elapsed) noexcept {
  ++now.bridged;
  listened += std::min(elapsed, 2.0 / options.rate);
  if (age > kHoldTime) last = damping;
  if (age > kStaleTime && listened > kListening) {
    now.gap = age;
    latch(RunReason::kStale);
  }
}

void StandRunner::Impl::obey_remote() noexcept {
  const WirelessRemote remote = decode_wireless_remote(link.state().wirelessRemote);
  controller.set_body_reference(remote_reference(remote));
  if (remote.pressed(kDampingButton)) latch(RunReason::kButton);
}

void StandRunner::Impl::latch(RunReason why) noexcept {
  if (now.phase != RunPhase::kStanding) return;
  now.phase = RunPhase::kDamping;
  now.reason = why;
  ++now.dampings;
  published = -1.0;  // say it at once
}

void StandRunner::Impl::end(RunReason why) noexcept {
  // What it ended for counts, unless it was damping for something before; and with no robot it has
  // controlled nothing, whoever asked for the end.
  if (now.phase == RunPhase::kWaiting && why == RunReason::kAsked) why = RunReason::kNoState;
  if (now.phase != RunPhase::kDamping) now.reason = why;
  now.phase = RunPhase::kEnded;
}

// The rest of what is seen from outside.
const RunSnapshot& StandRunner::Impl::describe() noexcept {
  now.link = link.counts();
  now.reject = link.last_reject();
  now.age = link.age();
  const RobotState& state = controller.state();
  now.height = state.q[2];
  const double sine = std::hypot(state.q[3], state.q[4]);  // of half the tilt
  now.tilt = 2.0 * std::asin(std::min(sine, 1.0));
  return now;
}

StandRunner::StandRunner(const Robot& robot, const Gains& gains, const StandOptions& stand,
                         const UdpLinkOptions& link, const RunOptions& options)
    : impl_(std::make_unique<Impl>(robot, gains, stand, link, options)) {}
StandRunner::~StandRunner() = default;

void StandRunner::stop() noexcept { impl_->stop.store(true); }
void StandRunner::damp() noexcept { impl_->damp.store(true); }
void StandRunner::rearm() noexcept { impl_->rearm.store(true); }
int StandRunner::local_port() const noexcept { return impl_->link.local_port(); }

RunSnapshot StandRunner::snapshot() const { return impl_->board.look(); }
std::string StandRunner::real_time() const { return impl_->board.real_time(); }

}  // namespace surefoot
