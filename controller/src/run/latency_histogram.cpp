// SPDX-License-Identifier: BSD-3-Clause
#include "run/latency_histogram.hpp"

#include <algorithm>
#include <cmath>

namespace surefoot {

namespace {
constexpr double kLeast = 0.25;  // [us]
constexpr double kBinsPerOctave = 16.0;
}  // namespace

void LatencyHistogram::add(double microseconds) noexcept {
  const double octaves = std::log2(std::max(microseconds, kLeast) / kLeast);
  const int bin = std::min(static_cast<int>(kBinsPerOctave * octaves), kBins - 1);
  ++bins_[bin];
  ++count_;
  greatest_ = std::max(greatest_, microseconds);
}

double LatencyHistogram::quantile(double share) const noexcept {
  const double wanted = share * static_cast<double>(count_);
  double below = 0.0;
  for (int bin = 0; bin < kBins; ++bin) {
    below += bins_[bin];
    if (below > 0.0 && below >= wanted) {
      return std::min(kLeast * std::exp2((bin + 1) / kBinsPerOctave), greatest_);
    }
  }
  return greatest_;
}

}  // namespace surefoot
