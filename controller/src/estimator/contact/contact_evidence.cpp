// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/contact/contact_evidence.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace surefoot {

namespace {
// [s] Duration from which a constant value can be a fault. Chosen. Longer than 0.022 s, the time
// for which a 50 Hz sensor may repeat a value. If larger: a stuck sensor reports contact of a
// lifted foot for longer.
constexpr double kStuckTime = 0.1;
// Load change of the foot, as a share of the weight, above which a working sensor must change its
// value. Chosen larger than contact_force_on (0.07) and the noise of the torques, and smaller than
// 0.25, the load of one foot.
constexpr double kMinLoadChange = 0.1;
// [counts] A sensor counts as saturated from this value on. Derived: just below 32767, the range of
// int16.
constexpr int kSaturationCount = 32000;
}  // namespace

double load_vote(const Gains& gains, double load, double load_sigma, bool loaded) noexcept {
  const double threshold = loaded ? gains.contact_force_off : gains.contact_force_on;
  return std::tanh((load - threshold) / std::max(gains.contact_force_width, load_sigma));
}

SensorVerdict StuckDetector::update(int value, double load, double dt) noexcept {
  if (!started_ || value != last_) {
    unchanged_time_ = 0.0;
    min_load_ = max_load_ = load;
  } else {
    unchanged_time_ += dt;
    min_load_ = std::fmin(min_load_, load);
    max_load_ = std::fmax(max_load_, load);
  }
  started_ = true;
  last_ = value;
  ever_nonzero_ = ever_nonzero_ || value != 0;
  if (std::abs(value) >= kSaturationCount) return SensorVerdict::kSaturated;
  if (!ever_nonzero_) return SensorVerdict::kZero;
  if (unchanged_time_ < kStuckTime || !(max_load_ - min_load_ > kMinLoadChange))
    return SensorVerdict::kGood;
  return value == 0 ? SensorVerdict::kZero : SensorVerdict::kConstant;
}

}  // namespace surefoot
