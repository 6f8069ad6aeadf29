// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>

namespace surefoot {

/// Histogram of durations from 0.25 us to 1 s. The bins have the width of 1/16 octave: a factor of
/// 2^(1/16). Real-time: yes.
class LatencyHistogram {
 public:
  void add(double microseconds) noexcept;

  std::uint64_t count() const noexcept { return count_; }
  /// Return the quantile for `share`, 0 .. 1, as the upper edge of its bin [us], but at most
  /// greatest(). Return 0 if there are no durations.
  double quantile(double share) const noexcept;
  /// Return the largest duration [us], not rounded to a bin.
  double greatest() const noexcept { return greatest_; }

 private:
  // Bins per octave times number of octaves, see latency_histogram.cpp.
  static constexpr int kBins = 16 * 22;
  std::array<std::uint32_t, kBins> bins_{};
  std::uint64_t count_ = 0;
  double greatest_ = 0.0;
};

}  // namespace surefoot
