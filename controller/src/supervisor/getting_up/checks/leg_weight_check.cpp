// SPDX-License-Identifier: BSD-3-Clause
#include "supervisor/getting_up/checks/leg_weight_check.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "supervisor/common/smoothstep.hpp"

namespace surefoot {

namespace {

// The constants are chosen by hand.
// [s] Duration of the hips' motion outward, and of the motion back. Chosen so that hips stay below
// 1 rad/s (test_rise_checks).
constexpr double kMoveTime = 0.6;
// [s] Pause before torques are averaged: five times the time constant D / K of the impedance.
constexpr double kSettleTime = 0.15;
constexpr double kAveragingTime = 0.2;  // [s] duration of the average: 100 ticks at 500 Hz
constexpr double kReturnTime = kMoveTime + kSettleTime + kAveragingTime;

}  // namespace

void LegWeightCheck::start(const Vector12& reference,
                           const std::array<bool, kLegs>& legs) noexcept {
  legs_ = legs;
  q_start_ = reference;
  reference_.q = reference;
  reference_.dq.setZero();
  measured_.setZero();
  model_.setZero();
  time_ = 0.0;
  verdict_ = Verdict::kNone;
  motor_ = -1;
}

const JointReference& LegWeightCheck::step(const Vector12& measured, const Vector12& model,
                                           double dt) noexcept {
  const bool averaged = time_ >= kReturnTime;
  time_ += dt;
  if (time_ >= kMoveTime + kSettleTime && !averaged) {
    for (int leg = 0; leg < kLegs; ++leg) {
      measured_[leg] += measured[kLegJoints * leg];
      model_[leg] += model[kLegJoints * leg];
    }
  }
  const double out =
      kHipOutward * (smoothstep(time_ / kMoveTime) - smoothstep((time_ - kReturnTime) / kMoveTime));
  for (int leg = 0; leg < kLegs; ++leg) {
    if (!legs_[leg]) continue;
    const int hip = kLegJoints * leg;
    const double q = q_start_[hip] + std::copysign(out, plan_.hip_outward_max[hip]);
    reference_.dq[hip] = (q - reference_.q[hip]) / dt;
    reference_.q[hip] = q;
  }
  // If the check fails, it ends before the hips have moved back.
  if (time_ >= kReturnTime && !averaged) judge();
  if (verdict_ == Verdict::kNone && time_ >= kReturnTime + kMoveTime) verdict_ = Verdict::kFits;
  return reference_;
}

// If the ratios are wrong but alike, the robot is not the robot of the model. If the ratio of one
// leg differs, this leg is on the wrong side. In the logarithm, ratios below 1e-3, negative ones
// included, count as 1e-3.
void LegWeightCheck::judge() noexcept {
  int worst = 0, heaviest = 0, count = 0;
  double off = -1.0, all = 0.0;
  double least = std::numeric_limits<double>::infinity(), most = -least;
  for (int leg = 0; leg < kLegs; ++leg) {
    if (!legs_[leg]) continue;
    const double share = measured_[leg] / model_[leg];
    const double size = std::log(std::max(share, 1e-3));
    if (std::abs(size) > off) worst = leg, off = std::abs(size);
    least = std::min(least, share);
    if (share > most) heaviest = leg, most = share;
    all += share;
    ++count;
  }
  all /= count;
  const bool all_legs = count == kLegs;
  const bool plausible =
      least > kMinRatio && most < kMaxRatio && all > kMinMeanRatio && all < kMaxMeanRatio;
  if (all_legs ? plausible : most < kMaxPartialRatio) return;
  if (!all_legs) worst = heaviest;
  const bool alike = least > 0.0 && most < kMaxSpread * least;
  motor_ = alike ? -1 : kLegJoints * worst;
  verdict_ = alike ? Verdict::kWrongWeight : Verdict::kWrongSide;
}

}  // namespace surefoot
