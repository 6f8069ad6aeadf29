// SPDX-License-Identifier: BSD-3-Clause
#include "surefoot/stand_runner.hpp"

#include <atomic>
#include <mutex>

#include "run/latency_histogram.hpp"
#include "run/real_time.hpp"
#include "run/remote_reference.hpp"
#include "safety/command_keeper.hpp"
#include "surefoot/safety.hpp"

namespace surefoot {

namespace {

constexpr double kFarewell = 0.2;         // [s] of damping frames at the end: UDP may lose some
constexpr double kPublishing = 0.05;      // [s] between looks from outside
constexpr std::uint64_t kConvinced = 10;  // datagrams of another generation
constexpr int kSilentTicks = 4;           // in a row without a LowState, before its age counts

}  // namespace

struct StandRunner::Impl {
  Impl(const Robot& robot, const Gains& gains, const StandOptions& stand,
       const UdpLinkOptions& link_options, const RunOptions& o)
      : options((o.validate(), o)),
        controller(robot, gains, stand),
        safety(robot),
        link(link_options),
        damping(damping_low_cmd(gains.damping_kd)) {}
  void tick() noexcept;
  void wait_for_robot() noexcept;
  void stand(bool newer) noexcept;
  void bridge() noexcept;
  void obey_remote() noexcept;
  void latch(RunReason why) noexcept;
  void begin() noexcept;
  void end(RunReason why) noexcept;
  void publish(std::unique_lock<std::mutex> lock) noexcept;

  RunOptions options;
  StandController controller;
  Safety safety;
  UdpLink link;
  LowCmd damping, last = damping;
  LatencyHistogram ticks, wakes;
  RunSnapshot now;  // the loop's own
  double start = 0.0, published = 0.0;
  int silent_ticks = 0;
  std::uint64_t restarts = 0;  // of the robot, when control began
  std::atomic<bool> stop{false}, damp{false}, rearm{false};
  mutable std::mutex mutex;  // of what follows; the loop only ever tries it
  RunSnapshot seen;
  std::string real_time = "not running";
};

void StandRunner::run() {
  Impl& s = *impl_;
  const RealTimeScope scope;
  {
    const std::lock_guard<std::mutex> lock(s.mutex);
    s.real_time = scope.scheduling() + ", " + scope.memory();
  }
  PeriodicTimer timer(1.0 / s.options.rate);
  s.start = monotonic_time();
  while (s.now.phase != RunPhase::kEnded) {
    s.wakes.add(timer.wait());
    const double woken = monotonic_time();
    s.tick();
    s.ticks.add(1e6 * (monotonic_time() - woken));
    s.now.time = woken - s.start;
    s.now.missed = static_cast<std::uint64_t>(timer.missed());
    if (s.now.time - s.published > kPublishing) s.publish({s.mutex, std::try_to_lock});
  }
  for (double t = 0.0; t < kFarewell; t += 1.0 / s.options.rate) {
    s.link.send(s.damping);
    timer.wait();
  }
  s.publish(std::unique_lock<std::mutex>(s.mutex));
}

void StandRunner::Impl::tick() noexcept {
  const bool newer = link.receive();
  if (stop.load() || now.time > options.duration) end(RunReason::kAsked);
  if (damp.exchange(false) && now.phase == RunPhase::kStanding) latch(RunReason::kAsked);
  const bool rearmed = rearm.exchange(false);
  switch (now.phase) {
    case RunPhase::kWaiting:
      wait_for_robot();
      break;
    case RunPhase::kStanding:
      stand(newer);
      break;
    case RunPhase::kDamping:
      link.send(damping);
      if (rearmed && link.age() < kStaleTime) {
        ++now.rearms;
        begin();
      }
      break;
    case RunPhase::kEnded:
      link.send(damping);
      break;
  }
}

void StandRunner::Impl::wait_for_robot() noexcept {
  link.send(damping);
  if (link.known()) {
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
  restarts = link.counts().restarts;
  now.phase = RunPhase::kStanding;
}

void StandRunner::Impl::stand(bool newer) noexcept {
  ++now.ticks;
  if (!newer) {
    bridge();
    return;
  }
  silent_ticks = 0;
  if (link.counts().restarts != restarts) latch(RunReason::kRestart);
  const LowState& state = link.state();
  if (options.remote) obey_remote();
  const LowCmd& cmd = controller.update(state);
  now.status = controller.status();
  now.fault = controller.fault();
  now.usable += is_usable(now.status);
  now.saturated += now.status == Status::kSaturated;
  if (options.power_level > 0) {
    const bool tripped = safety.power_protect(cmd, state, options.power_level) < 0;
    now.power = safety.power();
    now.greatest_power = std::max(now.greatest_power, now.power);
    if (tripped) latch(RunReason::kPowerProtect);
  }
  if (now.status == Status::kDamping) latch(RunReason::kController);
  last = now.phase == RunPhase::kStanding ? cmd : damping;
  link.send(last);
}

// No report since the last tick: the command before, then damping, then that for good.
void StandRunner::Impl::bridge() noexcept {
  const double age = link.age();
  ++now.bridged;
  ++silent_ticks;
  // When the system held this program up, the robot's reports may only just be coming.
  if (age > kStaleTime && silent_ticks >= kSilentTicks) {
    now.silence = age;
    latch(RunReason::kStale);
  }
  link.send(age > kHoldTime ? damping : last);
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
  published = 0.0;  // say it at once
}

void StandRunner::Impl::end(RunReason why) noexcept {
  // What it ended for counts, unless it was damping for something before.
  if (now.phase != RunPhase::kDamping) now.reason = why;
  now.phase = RunPhase::kEnded;
}

void StandRunner::Impl::publish(std::unique_lock<std::mutex> lock) noexcept {
  if (!lock.owns_lock()) return;
  published = now.time;
  seen = now;
  seen.link = link.counts();
  seen.reject = link.last_reject();
  seen.age = link.age();
  const RobotState& state = controller.state();
  seen.height = state.q[2];
  const double sine = std::hypot(state.q[3], state.q[4]);  // of half the tilt
  seen.tilt = 2.0 * std::asin(std::min(sine, 1.0));
  seen.tick_p50 = ticks.quantile(0.5);
  seen.tick_p90 = ticks.quantile(0.9);
  seen.tick_p99 = ticks.quantile(0.99);
  seen.tick_p999 = ticks.quantile(0.999);
  seen.tick_max = ticks.greatest();
  seen.wake_p50 = wakes.quantile(0.5);
  seen.wake_p99 = wakes.quantile(0.99);
  seen.wake_p999 = wakes.quantile(0.999);
  seen.wake_max = wakes.greatest();
}

StandRunner::StandRunner(const Robot& robot, const Gains& gains, const StandOptions& stand,
                         const UdpLinkOptions& link, const RunOptions& options)
    : impl_(std::make_unique<Impl>(robot, gains, stand, link, options)) {}
StandRunner::~StandRunner() = default;

void StandRunner::stop() noexcept { impl_->stop.store(true); }
void StandRunner::damp() noexcept { impl_->damp.store(true); }
void StandRunner::rearm() noexcept { impl_->rearm.store(true); }
int StandRunner::local_port() const noexcept { return impl_->link.local_port(); }

RunSnapshot StandRunner::snapshot() const {
  const std::lock_guard<std::mutex> lock(impl_->mutex);
  return impl_->seen;
}

std::string StandRunner::real_time() const {
  const std::lock_guard<std::mutex> lock(impl_->mutex);
  return impl_->real_time;
}

}  // namespace surefoot
