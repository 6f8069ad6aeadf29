// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/contact/foot_count.hpp"

#include <algorithm>
#include <cmath>

namespace surefoot {

namespace {
constexpr double kSmooth = 0.02;     // [s] keeps noise from passing for a change of load
constexpr double kOffsetTime = 5.0;  // [s] in which the offset follows a drift
constexpr double kNoiseSamples = 500.0;
constexpr double kScaleTime = 2.0;  // [s] of changing load in which the scale follows
constexpr double kExcited = 0.04;   // share of the weight by which a load has changed
constexpr double kEnough = 0.1;     // [s] of changing load before the line is believed
constexpr double kFollows = 0.5;    // least share of the counts' spread that the load explains
constexpr double kIgnores = 0.2;
constexpr double kRangeTime = 10.0;  // [s] in which the range that was seen is forgotten
constexpr double kRangeNoise = 8.0;  // times the noise that a range must span ...
constexpr double kLeastRange = 5.0;  // [counts] ... and at least this
constexpr double kRangeLoad = 0.4;   // share of the weight at the top of a range
}  // namespace

Evidence FootCount::update(const Gains& gains, int count, double load, bool sure, bool loaded,
                           double dt) noexcept {
  const double c = count;
  if (!started_) {
    last_ = smooth_count_ = mean_count_ = low_ = high_ = c;
    smooth_load_ = mean_load_ = std::isnan(load) ? 0.0 : load;
    started_ = true;
  }
  measure_noise(c);
  Evidence out;
  out.verdict = stuck_.see(count, load, dt);
  const double by_range = load_by_range(c, dt);
  if (out.verdict != Verdict::kGood) return out;
  if (std::isnan(load)) {
    if (std::isnan(by_range)) return {0.0, Verdict::kUnjudged};
    return range_says(gains, by_range, loaded);
  }
  if (sure) learn(c, load, dt);
  out.verdict = judge();
  if (out.verdict == Verdict::kUnjudged && !std::isnan(by_range))
    return range_says(gains, by_range, loaded);
  if (out.verdict != Verdict::kGood) return out;
  const double doubt = std::sqrt(noise_) / scale_;
  out.says = say_load(gains, (c - offset()) / scale_, 2.0 * doubt, loaded);
  return out;
}

// By differences of new samples: a sensor slower than the reports repeats its last.
void FootCount::measure_noise(double count) noexcept {
  if (count == last_) return;
  samples_ = std::min(samples_ + 1.0, kNoiseSamples);
  noise_ += (0.5 * (count - last_) * (count - last_) - noise_) / samples_;
  last_ = count;
}

Evidence FootCount::range_says(const Gains& gains, double load, bool loaded) const noexcept {
  const double doubt = kRangeLoad * std::sqrt(noise_) / (high_ - low_);
  return {say_load(gains, load, 2.0 * doubt, loaded), Verdict::kGood};
}

void FootCount::learn(double count, double load, double dt) noexcept {
  const double quick = dt / (dt + kSmooth), blend = dt / (dt + kOffsetTime);
  smooth_count_ += quick * (count - smooth_count_);
  smooth_load_ += quick * (load - smooth_load_);
  mean_count_ += blend * (smooth_count_ - mean_count_);
  mean_load_ += blend * (smooth_load_ - mean_load_);
  const double dc = smooth_count_ - mean_count_, df = smooth_load_ - mean_load_;
  if (std::abs(df) < kExcited) return;
  const double keep = 1.0 - dt / (dt + kScaleTime);
  weight_ = keep * weight_ + dt;
  spread_load_ = keep * spread_load_ + dt * df * df;
  spread_count_ = keep * spread_count_ + dt * dc * dc;
  covariance_ = keep * covariance_ + dt * dc * df;
  scale_ = std::max(covariance_ / spread_load_, 0.0);
}

Verdict FootCount::judge() const noexcept {
  if (weight_ < kEnough) return Verdict::kUnjudged;
  const double explained = covariance_ * covariance_ / (spread_load_ * spread_count_ + 1e-12);
  if (scale_ > 0.0 && explained > kFollows) return Verdict::kGood;
  if (explained > kIgnores && scale_ > 0.0) return Verdict::kUnjudged;
  return spread_count_ < 4.0 * weight_ * (noise_ + 1.0) ? Verdict::kConstant : Verdict::kDisagrees;
}

// Both ends of the range creep to the present count, so that a drift does not widen it for ever.
double FootCount::load_by_range(double count, double dt) noexcept {
  const double blend = dt / (dt + kRangeTime);
  low_ = std::min(count, low_ + blend * (count - low_));
  high_ = std::max(count, high_ + blend * (count - high_));
  const double range = high_ - low_;
  if (range < std::max(kLeastRange, kRangeNoise * std::sqrt(noise_))) return NAN;
  return kRangeLoad * (count - low_) / range;
}

}  // namespace surefoot
