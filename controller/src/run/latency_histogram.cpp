// SPDX-License-Identifier: BSD-3-Clause
#include "run/latency_histogram.hpp"

#include <algorithm>
#include <cmath>

namespace surefoot {

namespace {
// Chosen: the kBins bins cover 22 octaves (factors of 2), from 0.25 us (shorter than any tick) to
// 1 s. From one bin to the next the latency grows by a factor of 2^(1/16), or by 4 %.
constexpr double kMinLatency = 0.25;  // [us] lower edge of the first bin
constexpr double kBinsPerOctave = 16.0;
}  // namespace

void LatencyHistogram::add(double microseconds) noexcept {
  const double octaves = std::log2(std::max(microseconds, kMinLatency) / kMinLatency);
  const int bin = std::min(static_cast<int>(kBinsPerOctave * octaves), kBins - 1);
  ++bins_[bin];
  ++count_;
  greatest_ = std::max(greatest_, microseconds);
}

double LatencyHistogram::quantile(double share) const noexcept {
  const double target_count = share * static_cast<double>(count_);
  double cumulative_count = 0.0;
  for (int bin = 0; bin < kBins; ++bin) {
    cumulative_count += bins_[bin];
    if (cumulative_count > 0.0 && cumulative_count >= target_count) {
      return std::min(kMinLatency * std::exp2((bin + 1) / kBinsPerOctave), greatest_);
    }
  }
  return greatest_;
}

}  // namespace surefoot
