// SPDX-License-Identifier: BSD-3-Clause
#include "run/snapshot_publisher.hpp"

namespace surefoot {

void SnapshotPublisher::publish(const RunSnapshot& snapshot, const LatencyHistogram& tick_latencies,
                                const LatencyHistogram& wake_latencies, long missed) noexcept {
  const std::unique_lock<std::mutex> lock(mutex_, std::try_to_lock);
  if (lock.owns_lock()) write(snapshot, tick_latencies, wake_latencies, missed);
}

void SnapshotPublisher::publish_final(const RunSnapshot& snapshot,
                                      const LatencyHistogram& tick_latencies,
                                      const LatencyHistogram& wake_latencies, long missed) {
  const std::lock_guard<std::mutex> lock(mutex_);
  write(snapshot, tick_latencies, wake_latencies, missed);
}

void SnapshotPublisher::write(const RunSnapshot& snapshot, const LatencyHistogram& tick_latencies,
                              const LatencyHistogram& wake_latencies, long missed) noexcept {
  snapshot_ = snapshot;
  snapshot_.missed_periods = static_cast<std::uint64_t>(missed);
  tick_latencies_ = tick_latencies;
  wake_latencies_ = wake_latencies;
}

void SnapshotPublisher::set_real_time(const std::string& words) {
  const std::lock_guard<std::mutex> lock(mutex_);
  real_time_ = words;
}

RunSnapshot SnapshotPublisher::snapshot() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  RunSnapshot snapshot = snapshot_;
  snapshot.tick_p50 = tick_latencies_.quantile(0.5);
  snapshot.tick_p90 = tick_latencies_.quantile(0.9);
  snapshot.tick_p99 = tick_latencies_.quantile(0.99);
  snapshot.tick_p999 = tick_latencies_.quantile(0.999);
  snapshot.tick_max = tick_latencies_.greatest();
  snapshot.wake_p50 = wake_latencies_.quantile(0.5);
  snapshot.wake_p99 = wake_latencies_.quantile(0.99);
  snapshot.wake_p999 = wake_latencies_.quantile(0.999);
  snapshot.wake_max = wake_latencies_.greatest();
  return snapshot;
}

std::string SnapshotPublisher::real_time() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return real_time_;
}

}  // namespace surefoot
