// SPDX-License-Identifier: BSD-3-Clause
#include "surefoot/stand_runner.hpp"

#include <atomic>

#include "common/clock.hpp"
#include "run/latency_histogram.hpp"
#include "run/real_time_scope.hpp"
#include "run/snapshot_publisher.hpp"
#include "run/stand_loop.hpp"
#include "surefoot/error.hpp"

namespace surefoot {

namespace {

// [s] Time for which damping frames are sent at the end of a run. They are repeated because UDP may
// lose some of them. Derived: twice kRobotWatchdogTime.
constexpr double kFinalDampingTime = 0.2;
// [s] Time between published snapshots. Chosen. If shorter: the loop spends more time on copies. If
// longer: an operator who watches the run sees changes too late.
constexpr double kPublishPeriod = 0.05;

/// Flag that is set while the loop runs. It is also cleared if an exception ends the loop.
class RunningFlag {
 public:
  explicit RunningFlag(std::atomic<bool>& flag) : flag_(flag) { flag_.store(true); }
  ~RunningFlag() { flag_.store(false); }
  RunningFlag(const RunningFlag&) = delete;
  RunningFlag& operator=(const RunningFlag&) = delete;

 private:
  std::atomic<bool>& flag_;
};

}  // namespace

struct StandRunner::Impl {
  Impl(const Robot& robot, const Gains& gains, const StandOptions& stand,
       const UdpLinkOptions& link, const RunOptions& options)
      : loop(robot, gains, stand, link, options), period(1.0 / options.rate) {}

  StandLoop loop;
  double period;
  LatencyHistogram tick_latencies, wake_latencies;
  SnapshotPublisher publisher;
  std::atomic<bool> started{false}, running{false};
};

void StandRunner::run() {
  Impl& s = *impl_;
  if (s.started.exchange(true))
    throw Error("run: got a second call, expected one per StandRunner: create a new StandRunner");
  const RunningFlag running(s.running);
  const RealTimeScope scope;
  s.publisher.set_real_time(scope.scheduling() + ", " + scope.memory());
  PeriodicTimer timer(s.period);
  const double start = monotonic_time();
  double time = 0.0, published = 0.0;
  while (!s.loop.ended()) {
    s.wake_latencies.add(timer.wait());
    const double wake_time = monotonic_time();
    const double elapsed = wake_time - start - time;
    time += elapsed;
    s.loop.tick(time, elapsed);
    s.tick_latencies.add(1e6 * (monotonic_time() - wake_time));
    if (s.loop.take_phase_change() || time - published > kPublishPeriod) {
      published = time;
      s.publisher.publish(s.loop.snapshot(), s.tick_latencies, s.wake_latencies, timer.missed());
    }
  }
  for (double t = 0.0; t < kFinalDampingTime; t += s.period) {
    s.loop.send_damping();
    timer.wait();
  }
  s.publisher.publish_final(s.loop.snapshot(), s.tick_latencies, s.wake_latencies, timer.missed());
}

StandRunner::StandRunner(const Robot& robot, const Gains& gains, const StandOptions& stand,
                         const UdpLinkOptions& link, const RunOptions& options)
    : impl_(std::make_unique<Impl>(robot, gains, stand, link, options)) {}
StandRunner::~StandRunner() = default;

RequestStatus StandRunner::request(Mode mode) noexcept { return impl_->loop.request(mode); }
RequestStatus StandRunner::arm() noexcept { return impl_->loop.arm(); }
void StandRunner::finish() noexcept { impl_->loop.finish(); }
void StandRunner::stop() noexcept { impl_->loop.stop(); }
void StandRunner::damp() noexcept { impl_->loop.damp(); }
void StandRunner::heartbeat() noexcept { impl_->loop.heartbeat(); }
void StandRunner::rearm() noexcept { impl_->loop.rearm(); }
void StandRunner::set_gains(const Gains& gains) { impl_->loop.set_gains(gains); }
void StandRunner::set_body_reference(const BodyReference& target) {
  impl_->loop.set_body_reference(target);
}
int StandRunner::local_port() const noexcept { return impl_->loop.local_port(); }
const RunLog& StandRunner::log() const {
  if (impl_->running.load())
    throw Error("log: got a call while run() is running, expected one after its end");
  return impl_->loop.log();
}
RunSnapshot StandRunner::snapshot() const { return impl_->publisher.snapshot(); }
std::string StandRunner::real_time() const { return impl_->publisher.real_time(); }

}  // namespace surefoot
