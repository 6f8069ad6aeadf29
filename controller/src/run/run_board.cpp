// SPDX-License-Identifier: BSD-3-Clause
#include "run/run_board.hpp"

namespace surefoot {

void RunBoard::publish(const RunSnapshot& now, const LatencyHistogram& ticks,
                       const LatencyHistogram& wakes, long missed) noexcept {
  const std::unique_lock<std::mutex> lock(mutex_, std::try_to_lock);
  if (lock.owns_lock()) write(now, ticks, wakes, missed);
}

void RunBoard::publish_last(const RunSnapshot& now, const LatencyHistogram& ticks,
                            const LatencyHistogram& wakes, long missed) {
  const std::lock_guard<std::mutex> lock(mutex_);
  write(now, ticks, wakes, missed);
}

void RunBoard::write(const RunSnapshot& now, const LatencyHistogram& ticks,
                     const LatencyHistogram& wakes, long missed) noexcept {
  seen_ = now;
  seen_.missed = static_cast<std::uint64_t>(missed);
  ticks_ = ticks;
  wakes_ = wakes;
}

void RunBoard::set_real_time(const std::string& words) {
  const std::lock_guard<std::mutex> lock(mutex_);
  real_time_ = words;
}

RunSnapshot RunBoard::look() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  RunSnapshot now = seen_;
  now.tick_p50 = ticks_.quantile(0.5);
  now.tick_p90 = ticks_.quantile(0.9);
  now.tick_p99 = ticks_.quantile(0.99);
  now.tick_p999 = ticks_.quantile(0.999);
  now.tick_max = ticks_.greatest();
  now.wake_p50 = wakes_.quantile(0.5);
  now.wake_p99 = wakes_.quantile(0.99);
  now.wake_p999 = wakes_.quantile(0.999);
  now.wake_max = wakes_.greatest();
  return now;
}

std::string RunBoard::real_time() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return real_time_;
}

}  // namespace surefoot
