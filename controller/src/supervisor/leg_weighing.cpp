// SPDX-License-Identifier: BSD-3-Clause
#include "supervisor/leg_weighing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "supervisor/smooth.hpp"

namespace surefoot {

namespace {

constexpr double kWay = 0.6;    // [s] that the hips take outward, and back
constexpr double kRest = 0.15;  // [s] before torques count
constexpr double kLook = 0.2;   // [s] that they are averaged over
constexpr double kBack = kWay + kRest + kLook;

}  // namespace

void LegWeighing::start(const Vector12& reference, const std::array<bool, kLegs>& legs) noexcept {
  legs_ = legs;
  start_ = reference;
  reference_.q = reference;
  reference_.dq.setZero();
  measured_.setZero();
  model_.setZero();
  time_ = 0.0;
  verdict_ = Verdict::kNone;
  motor_ = -1;
}

const JointReference& LegWeighing::step(const Vector12& measured, const Vector12& model,
                                        double dt) noexcept {
  const bool looked = time_ >= kBack;
  time_ += dt;
  if (time_ >= kWay + kRest && !looked) {
    for (int leg = 0; leg < kLegs; ++leg) {
      measured_[leg] += measured[kLegJoints * leg];
      model_[leg] += model[kLegJoints * leg];
    }
  }
  const double out = kOut * (smooth(time_ / kWay) - smooth((time_ - kBack) / kWay));
  for (int leg = 0; leg < kLegs; ++leg) {
    if (!legs_[leg]) continue;
    const int hip = kLegJoints * leg;
    const double q = start_[hip] + std::copysign(out, plan_.widest[hip]);
    reference_.dq[hip] = (q - reference_.q[hip]) / dt;
    reference_.q[hip] = q;
  }
  // What is wrong need not wait until the hips are back.
  if (time_ >= kBack && !looked) judge();
  if (verdict_ == Verdict::kNone && time_ >= kBack + kWay) verdict_ = Verdict::kFits;
  return reference_;
}

// All legs alike are another robot's; one that is not like the others is in the wrong place.
void LegWeighing::judge() noexcept {
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
  const bool whole = count == kLegs;
  const bool in_air = least > kLeast && most < kMost && all > kLight && all < kHeavy;
  if (whole ? in_air : most < kAdded) return;
  if (!whole) worst = heaviest;
  const bool alike = least > 0.0 && most < kAlike * least;
  motor_ = alike ? -1 : kLegJoints * worst;
  verdict_ = alike ? Verdict::kWrongWeight : Verdict::kWrongSide;
}

}  // namespace surefoot
