// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>

namespace surefoot {

/// Counts durations in bins of 1/16 octave, from 0.25 us to 1 s. Real-time: yes.
class LatencyHistogram {
 public:
  void add(double microseconds) noexcept;

  std::uint64_t count() const noexcept { return count_; }
  /// Upper edge of the bin in which the share lies [us]; 0 with nothing counted.
  double quantile(double share) const noexcept;
  double greatest() const noexcept { return greatest_; }  ///< [us] exact

 private:
  static constexpr int kBins = 16 * 22;
  std::array<std::uint32_t, kBins> bins_{};
  std::uint64_t count_ = 0;
  double greatest_ = 0.0;
};

}  // namespace surefoot
