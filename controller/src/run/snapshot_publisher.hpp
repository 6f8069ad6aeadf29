// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mutex>
#include <string>

#include "run/latency_histogram.hpp"
#include "surefoot/stand_runner.hpp"

namespace surefoot {

/// Where the loop shows how it is, and others look.
class SnapshotPublisher {
 public:
  /// From the loop; skipped while someone looks. Real-time: yes.
  void publish(const RunSnapshot& snapshot, const LatencyHistogram& tick_latencies,
               const LatencyHistogram& wake_latencies, long missed) noexcept;
  /// At the end of the loop; waits for whoever looks.
  void publish_final(const RunSnapshot& snapshot, const LatencyHistogram& tick_latencies,
                     const LatencyHistogram& wake_latencies, long missed);
  void set_real_time(const std::string& words);

  /// From other threads: what was published last, with the percentiles of then.
  RunSnapshot snapshot() const;
  std::string real_time() const;

 private:
  void write(const RunSnapshot& snapshot, const LatencyHistogram& tick_latencies,
             const LatencyHistogram& wake_latencies, long missed) noexcept;

  mutable std::mutex mutex_;
  RunSnapshot snapshot_;
  LatencyHistogram tick_latencies_, wake_latencies_;
  std::string real_time_ = "not running";
};

}  // namespace surefoot
