// SPDX-License-Identifier: BSD-3-Clause
// Arming checks that need the robot's own limits, pose and weight.
#include <algorithm>
#include <cmath>

#include "supervisor/arming/arming_checks.hpp"

namespace surefoot {

namespace {

constexpr double kFootForceTolerance = 0.25;  // that the feet's forces may be off m g
constexpr double kStandingTolerance = 0.35;   // [rad] off the standing pose that is still standing
constexpr double kSwapMargin = 0.2;  // [rad] outside its range by which an angle is another's

}  // namespace

void ArmingChecks::check_joints(const LowState& state) noexcept {
  const RobotConfig& config = robot_.config();
  ArmingCheck worst;
  worst.value = -1e9;
  for (int i = 0; i < kMotors; ++i) {
    const double q = state.motorState[i].q;
    const double outside = std::max(q - config.q_upper[i], config.q_lower[i] - q);
    if (outside <= worst.value) continue;
    worst.value = outside;
    worst.motor = i;
    if (std::isnan(outside)) break;  // no other is worse
  }
  check_below(worst, worst.value, -limits_.joint_margin);
  at(ArmingCheckId::kJoints) = worst;
}

// An angle that is outside its own motor's range, by more than joints that rest on their stops, and
// inside another's of the same leg, or no further outside, while that one's fits here: the two are
// swapped. Only what the ranges tell apart can be seen: calves. Without another, far outside.
void ArmingChecks::check_order(const LowState& state) noexcept {
  const RobotConfig& config = robot_.config();
  const auto outside = [&](int angle_of, int motor) {
    const double q = state.motorState[angle_of].q;
    return std::max(q - config.q_upper[motor], config.q_lower[motor] - q);
  };
  ArmingCheck& check = at(ArmingCheckId::kMotorOrder);
  check = {};
  check.passed = true;
  check.limit = kSwapMargin;
  const double slack = -limits_.joint_margin;
  for (int i = 0; i < kMotors; ++i) {
    if (outside(i, i) < std::min(slack, kSwapMargin)) continue;
    const int leg = i - i % kLegJoints;
    double best = slack;
    int other = -1;
    for (int k = leg; k < leg + kLegJoints; ++k) {
      const double fit = std::max(outside(i, k), outside(k, i));
      if (k == i || !(fit < best)) continue;  // nor what is no number
      best = fit;
      other = k;
    }
    if (other < 0 && outside(i, i) < kSwapMargin) continue;
    check.passed = false;
    check.motor = i;
    check.swapped_with = other;
    check.value = outside(i, i);
    return;
  }
}

void ArmingChecks::check_feet(const LowState& state) noexcept {
  const RobotConfig& config = robot_.config();
  double total = 0.0, off = 0.0;
  for (int i = 0; i < kLegs; ++i) total += state.footForceEst[i];
  for (int i = 0; i < kMotors; ++i) {
    off = std::max(off, std::abs(state.motorState[i].q - config.q_standing[i]));
  }
  ArmingCheck& check = at(ArmingCheckId::kFootForce);
  check_below(check, std::abs(total / (robot_.mass() * kGravity) - 1.0), kFootForceTolerance);
  check.applies = off < kStandingTolerance && total != 0.0;
}

}  // namespace surefoot
