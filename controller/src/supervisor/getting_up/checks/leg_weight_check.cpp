// SPDX-License-Identifier: BSD-3-Clause
#include "supervisor/getting_up/checks/leg_weight_check.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "supervisor/common/smoothstep.hpp"

namespace surefoot {

namespace {

// The constants are chosen by hand.
// [s] Duration of the hips' motion outward, and of the motion back. The hips reach
// 1.5 kHipOutward / kMoveTime = 0.9 rad/s, and must stay below 1 rad/s (test_rise_checks).
constexpr double kMoveTime = 0.6;
// [s] Pause before torques are averaged: five times the time constant D / K of JointImpedance
// (kDampingTime in rise_plan.cpp), so that the hips come to rest.
constexpr double kSettleTime = 0.15;
constexpr double kAveragingTime = 0.2;  // [s] duration of the average: 100 ticks at 500 Hz
// [s] Time since the start at which the average ends and the hips begin to move back.
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
  const bool already_averaged = time_ >= kReturnTime;
  time_ += dt;
  if (time_ >= kMoveTime + kSettleTime && !already_averaged) {
    for (int leg = 0; leg < kLegs; ++leg) {
      measured_[leg] += measured[kLegJoints * leg];
      model_[leg] += model[kLegJoints * leg];
    }
  }
  const double outward_angle =
      kHipOutward * (smoothstep(time_ / kMoveTime) - smoothstep((time_ - kReturnTime) / kMoveTime));
  for (int leg = 0; leg < kLegs; ++leg) {
    if (!legs_[leg]) continue;
    const int hip = kLegJoints * leg;
    const double q = q_start_[hip] + std::copysign(outward_angle, plan_.hip_outward_limit[hip]);
    reference_.dq[hip] = (q - reference_.q[hip]) / dt;
    reference_.q[hip] = q;
  }
  // If the check fails, it ends before the hips have moved back.
  if (time_ >= kReturnTime && !already_averaged) judge();
  if (verdict_ == Verdict::kNone && time_ >= kReturnTime + kMoveTime) verdict_ = Verdict::kFits;
  return reference_;
}

// Judge the ratios measured / model. If the ratios are wrong but alike, the robot is not the robot
// of the model (kWrongWeight). Otherwise the leg with the worst ratio is on the wrong side
// (kWrongSide). The worst ratio is the one whose logarithm has the largest magnitude; ratios below
// 1e-3, also negative ratios, count as 1e-3. If only one side is weighed, the worst ratio is the
// largest one.
void LegWeightCheck::judge() noexcept {
  int worst = 0, heaviest = 0, leg_count = 0;
  double worst_log_ratio = -1.0, mean_ratio = 0.0;
  double min_ratio = std::numeric_limits<double>::infinity(), max_ratio = -min_ratio;
  for (int leg = 0; leg < kLegs; ++leg) {
    if (!legs_[leg]) continue;
    const double ratio = measured_[leg] / model_[leg];
    const double log_ratio = std::log(std::max(ratio, 1e-3));
    if (std::abs(log_ratio) > worst_log_ratio) worst = leg, worst_log_ratio = std::abs(log_ratio);
    min_ratio = std::min(min_ratio, ratio);
    if (ratio > max_ratio) heaviest = leg, max_ratio = ratio;
    mean_ratio += ratio;
    ++leg_count;
  }
  mean_ratio /= leg_count;
  const bool all_legs = leg_count == kLegs;
  const bool plausible = min_ratio > kMinRatio && max_ratio < kMaxRatio &&
                         mean_ratio > kMinMeanRatio && mean_ratio < kMaxMeanRatio;
  if (all_legs ? plausible : max_ratio < kMaxPartialRatio) return;
  if (!all_legs) worst = heaviest;
  const bool alike = min_ratio > 0.0 && max_ratio < kMaxSpread * min_ratio;
  motor_ = alike ? -1 : kLegJoints * worst;
  verdict_ = alike ? Verdict::kWrongWeight : Verdict::kWrongSide;
}

}  // namespace surefoot
