// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/contact/foot_force_calibration.hpp"

#include <algorithm>
#include <cmath>

namespace surefoot {

namespace {
// Fit of counts = offset + scale load. All values are chosen. Test: test_contact.cpp.
//
// [s] Time constant of the low-pass of counts and load, so that noise does not count as a load
// change. Longer than single samples, shorter than a step of the robot.
constexpr double kFilterTime = 0.02;
// [s] Time constant of the means from which the offset is computed. Longer than load changes.
// Shorter than a minute, because the counts drift within a minute.
constexpr double kOffsetTime = 5.0;
constexpr double kNoiseSamples = 500.0;  // number of samples in the noise average: 1 s at 500 Hz
// [s] Time constant of the scale, counted only while the load changes. If smaller: the fit is
// noisy. If larger: the scale follows drift too late.
constexpr double kScaleTime = 2.0;
// Load change, as a share of the weight, below which the scale is not updated. Larger than the
// noise of the torques, smaller than contact_force_off, 0.06.
constexpr double kMinLoadChange = 0.04;
// [s] Total time of changing load after which the fit is used: five times kFilterTime.
constexpr double kMinFitTime = 0.1;
// Coefficients of determination r^2 of the fit. Above kMinExplained the fit is good. Below
// kMaxUncorrelated the counts do not follow the load. Between these values the verdict is
// kUnjudged.
constexpr double kMinExplained = 0.5;
constexpr double kMaxUncorrelated = 0.2;
// [s] Time constant with which the observed range shrinks: twice kOffsetTime.
constexpr double kRangeTime = 10.0;
// The load is computed from the observed range only if the range is at least kRangeNoise standard
// deviations of the noise (four to either side), and at least kMinRange counts (quantisation).
constexpr double kRangeNoise = 8.0;
constexpr double kMinRange = 5.0;
// Load that is assumed at the top of the observed range, as a share of the weight. Between 0.25,
// the load of one of four stance feet, and 0.5, the load of one of two diagonal stance feet.
constexpr double kLoadAtMaxCount = 0.4;
}  // namespace

ContactEvidence FootForceCalibration::update(const Gains& gains, int count, double load,
                                             bool load_reliable, bool loaded, double dt) noexcept {
  const double c = count;
  if (!started_) {
    last_count_ = smooth_count_ = mean_count_ = min_count_ = max_count_ = c;
    smooth_load_ = mean_load_ = std::isnan(load) ? 0.0 : load;
    started_ = true;
  }
  measure_noise(c);
  ContactEvidence out;
  out.verdict = stuck_.update(count, load, dt);
  const double range_load = load_by_range(c, dt);
  if (out.verdict != SensorVerdict::kGood) return out;
  if (std::isnan(load)) {
    if (std::isnan(range_load)) return {0.0, SensorVerdict::kUnjudged};
    return range_evidence(gains, range_load, loaded);
  }
  if (load_reliable) update_fit(c, load, dt);
  out.verdict = fit_verdict();
  if (out.verdict == SensorVerdict::kUnjudged && !std::isnan(range_load))
    return range_evidence(gains, range_load, loaded);
  if (out.verdict != SensorVerdict::kGood) return out;
  const double load_sigma = std::sqrt(noise_) / scale_;
  out.vote = load_vote(gains, (c - offset()) / scale_, 2.0 * load_sigma, loaded);
  return out;
}

// Update the noise variance from the difference of two counts, which has twice this variance. Equal
// counts are skipped, because a sensor that is slower than the samples repeats its last value.
void FootForceCalibration::measure_noise(double count) noexcept {
  if (count == last_count_) return;
  samples_ = std::min(samples_ + 1.0, kNoiseSamples);
  noise_ += (0.5 * (count - last_count_) * (count - last_count_) - noise_) / samples_;
  last_count_ = count;
}

ContactEvidence FootForceCalibration::range_evidence(const Gains& gains, double load,
                                                     bool loaded) const noexcept {
  const double load_sigma = kLoadAtMaxCount * std::sqrt(noise_) / (max_count_ - min_count_);
  return {load_vote(gains, load, 2.0 * load_sigma, loaded), SensorVerdict::kGood};
}

void FootForceCalibration::update_fit(double count, double load, double dt) noexcept {
  const double filter_blend = dt / (dt + kFilterTime), blend = dt / (dt + kOffsetTime);
  smooth_count_ += filter_blend * (count - smooth_count_);
  smooth_load_ += filter_blend * (load - smooth_load_);
  mean_count_ += blend * (smooth_count_ - mean_count_);
  mean_load_ += blend * (smooth_load_ - mean_load_);
  const double dc = smooth_count_ - mean_count_, df = smooth_load_ - mean_load_;
  if (std::abs(df) < kMinLoadChange) return;
  const double decay = 1.0 - dt / (dt + kScaleTime);
  fit_time_ = decay * fit_time_ + dt;
  spread_load_ = decay * spread_load_ + dt * df * df;
  spread_count_ = decay * spread_count_ + dt * dc * dc;
  covariance_ = decay * covariance_ + dt * dc * df;
  scale_ = std::max(covariance_ / spread_load_, 0.0);
}

SensorVerdict FootForceCalibration::fit_verdict() const noexcept {
  if (fit_time_ < kMinFitTime) return SensorVerdict::kUnjudged;
  const double explained = covariance_ * covariance_ / (spread_load_ * spread_count_ + 1e-12);
  if (scale_ > 0.0 && explained > kMinExplained) return SensorVerdict::kGood;
  if (explained > kMaxUncorrelated && scale_ > 0.0) return SensorVerdict::kUnjudged;
  // Constant: the counts change by less than two standard deviations of their noise, which is taken
  // as at least 1 count.
  return spread_count_ < 4.0 * fit_time_ * (noise_ + 1.0) ? SensorVerdict::kConstant
                                                          : SensorVerdict::kDisagrees;
}

// Return the load, as a share of the weight, from the position of a count in the observed range.
// Return NaN while the range is too small. Both ends of the range move slowly towards the present
// count, so that drift cannot widen the range for ever.
double FootForceCalibration::load_by_range(double count, double dt) noexcept {
  const double blend = dt / (dt + kRangeTime);
  min_count_ = std::min(count, min_count_ + blend * (count - min_count_));
  max_count_ = std::max(count, max_count_ + blend * (count - max_count_));
  const double range = max_count_ - min_count_;
  if (range < std::max(kMinRange, kRangeNoise * std::sqrt(noise_))) return NAN;
  return kLoadAtMaxCount * (count - min_count_) / range;
}

}  // namespace surefoot
