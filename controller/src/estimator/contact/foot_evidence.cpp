// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/contact/foot_evidence.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace surefoot {

namespace {
constexpr double kHeld = 0.1;   // [s] before a value that stands still is suspicious
constexpr double kMoved = 0.1;  // share of the weight by which others have moved meanwhile
constexpr int kRange = 32000;   // of an int16
}  // namespace

double say_load(const Gains& gains, double load, double doubt, bool loaded) noexcept {
  const double threshold = loaded ? gains.contact_force_off : gains.contact_force_on;
  return std::tanh((load - threshold) / std::max(gains.contact_force_width, doubt));
}

Verdict StuckDetector::see(int value, double load, double dt) noexcept {
  if (!started_ || value != last_) {
    held_ = 0.0;
    least_ = most_ = load;
  } else {
    held_ += dt;
    least_ = std::fmin(least_, load);
    most_ = std::fmax(most_, load);
  }
  started_ = true;
  last_ = value;
  ever_ = ever_ || value != 0;
  if (std::abs(value) >= kRange) return Verdict::kSaturated;
  if (!ever_) return Verdict::kZero;
  if (held_ < kHeld || !(most_ - least_ > kMoved)) return Verdict::kGood;
  return value == 0 ? Verdict::kZero : Verdict::kConstant;
}

}  // namespace surefoot
