// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mutex>
#include <string>

#include "run/latency_histogram.hpp"
#include "surefoot/runner.hpp"

namespace surefoot {

/// Passes snapshots of the loop, and latency histograms, to other threads.
class SnapshotPublisher {
 public:
  /// Publish a snapshot from the loop. The snapshot is skipped while another thread reads.
  /// Real-time: yes.
  void publish(const RunSnapshot& snapshot, const LatencyHistogram& tick_latencies,
               const LatencyHistogram& wake_latencies, long missed) noexcept;
  /// Publish the last snapshot, at the end of the loop. This waits for other threads. Real-time:
  /// no.
  void publish_final(const RunSnapshot& snapshot, const LatencyHistogram& tick_latencies,
                     const LatencyHistogram& wake_latencies, long missed);
  /// Set the text of real_time(): the scheduling and memory locking obtained.
  void set_real_time(const std::string& words);

  /// Return the last published snapshot and its latency quantiles. Call it from other threads.
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
