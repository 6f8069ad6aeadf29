// SPDX-License-Identifier: BSD-3-Clause
#include "surefoot/runner.hpp"

#include <atomic>
#include <utility>

#include "common/clock.hpp"
#include "run/latency_histogram.hpp"
#include "run/real_time_scope.hpp"
#include "run/run_loop.hpp"
#include "run/snapshot_publisher.hpp"
#include "surefoot/error.hpp"

namespace surefoot {

namespace {

// [s] Time for which damping frames are sent at the end of a run. They are repeated because UDP may
// lose some of them. Derived: twice kRobotWatchdogTime.
constexpr double kFinalDampingTime = 0.2;
// [s] Time between published snapshots. Chosen. If shorter: the loop spends more time on copies. If
// longer: an operator who watches the run sees changes too late.
constexpr double kPublishPeriod = 0.05;

void check_start(const RunOptions& options, bool real_robot) {
  if (real_robot && options.start != Start::kLying) {
    throw Error(
        "start: got 'standing' with a real robot, expected 'lying': arming checks must pass before "
        "it moves (surefoot run --rise --real-robot)");
  }
}

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

struct Runner::Impl {
  Impl(const Robot& robot, const Gains& gains, const ControllerOptions& stand,
       std::shared_ptr<RobotLink> link, const RunOptions& options)
      : loop(robot, gains, stand, std::move(link), options), period(1.0 / options.rate) {}

  RunLoop loop;
  int local_port = 0;  // of a UdpLink
  double period;
  LatencyHistogram tick_latencies, wake_latencies;
  SnapshotPublisher publisher;
  std::atomic<bool> started{false}, running{false};
};

void Runner::run() {
  Impl& s = *impl_;
  if (s.started.exchange(true))
    throw Error("run: got a second call, expected one per Runner: create a new Runner");
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

Runner::Runner(const Robot& robot, const Gains& gains, const ControllerOptions& stand,
               const UdpLinkOptions& link, const RunOptions& options) {
  check_start(options, link.real_robot);
  auto udp_link = std::make_shared<UdpLink>(link);
  const int local_port = udp_link->local_port();
  impl_ = std::make_unique<Impl>(robot, gains, stand, std::move(udp_link), options);
  impl_->local_port = local_port;
}
Runner::Runner(const Robot& robot, const Gains& gains, const ControllerOptions& stand,
               std::shared_ptr<RobotLink> link, const RunOptions& options) {
  if (link == nullptr) throw Error("link: got none, expected an open link");
  check_start(options, link->allows_real_robot());
  impl_ = std::make_unique<Impl>(robot, gains, stand, std::move(link), options);
}
Runner::~Runner() = default;

RequestStatus Runner::request(Mode mode) noexcept { return impl_->loop.request(mode); }
RequestStatus Runner::arm() noexcept { return impl_->loop.arm(); }
void Runner::finish() noexcept { impl_->loop.finish(); }
void Runner::stop() noexcept { impl_->loop.stop(); }
void Runner::damp() noexcept { impl_->loop.damp(); }
void Runner::heartbeat() noexcept { impl_->loop.heartbeat(); }
void Runner::rearm() noexcept { impl_->loop.rearm(); }
void Runner::set_gains(const Gains& gains) { impl_->loop.set_gains(gains); }
void Runner::set_body_reference(const BodyReference& target) {
  impl_->loop.set_body_reference(target);
}
void Runner::set_velocity(const WalkVelocity& velocity) { impl_->loop.set_velocity(velocity); }
void Runner::set_gait(Gait gait) { impl_->loop.set_gait(gait); }
int Runner::local_port() const noexcept { return impl_->local_port; }
const RunLog& Runner::log() const {
  if (impl_->running.load())
    throw Error("log: got a call while run() is running, expected one after its end");
  return impl_->loop.log();
}
RunSnapshot Runner::snapshot() const { return impl_->publisher.snapshot(); }
std::string Runner::real_time() const { return impl_->publisher.real_time(); }

}  // namespace surefoot
