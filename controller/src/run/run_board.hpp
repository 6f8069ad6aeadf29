// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mutex>
#include <string>

#include "run/latency_histogram.hpp"
#include "surefoot/stand_runner.hpp"

namespace surefoot {

/// Where the loop shows how it is, and others look.
class RunBoard {
 public:
  /// From the loop; skipped while someone looks. Real-time: yes.
  void publish(const RunSnapshot& now, const LatencyHistogram& ticks, const LatencyHistogram& wakes,
               long missed) noexcept;
  /// At the end of the loop; waits for whoever looks.
  void publish_last(const RunSnapshot& now, const LatencyHistogram& ticks,
                    const LatencyHistogram& wakes, long missed);
  void set_real_time(const std::string& words);

  /// From other threads: what was published last, with the percentiles of then.
  RunSnapshot look() const;
  std::string real_time() const;

 private:
  void write(const RunSnapshot& now, const LatencyHistogram& ticks, const LatencyHistogram& wakes,
             long missed) noexcept;

  mutable std::mutex mutex_;
  RunSnapshot seen_;
  LatencyHistogram ticks_, wakes_;
  std::string real_time_ = "not running";
};

}  // namespace surefoot
