// SPDX-License-Identifier: BSD-3-Clause
// Arming checks of joint angles and foot forces against the model.
#include <algorithm>
#include <cmath>

#include "supervisor/arming/arming_checks.hpp"

namespace surefoot {

namespace {

// The constants are chosen by hand.
//
// [m g] Error of the sum of foot forces from which the check fails. Larger than sensor errors. Not
// larger than 0.25, the error if one of four foot forces is missing.
constexpr double kFootForceTolerance = 0.25;
// [rad] 20 degrees: largest joint error from q_standing for which the robot counts as standing.
// Same value as kUprightTolerance in supervisor_modes.cpp.
constexpr double kStandingTolerance = 0.35;
// [rad] An angle that is outside the range of its motor by this or more cannot be from that motor.
// Larger than the 0.15 that joint_margin allows for a folded calf. Test:
// failed_arming_checks_are_named.
constexpr double kSwapMargin = 0.2;

}  // namespace

void ArmingChecks::check_joints(const LowState& state) noexcept {
  const RobotConfig& config = robot_.config();
  ArmingCheck worst;
  worst.value = -1e9;  // [rad] lower than any distance
  for (int i = 0; i < kMotors; ++i) {
    const double q = state.motorState[i].q;
    const double outside = std::max(q - config.q_upper[i], config.q_lower[i] - q);
    if (outside <= worst.value) continue;
    worst.value = outside;
    worst.motor = i;
    if (std::isnan(outside)) break;  // NaN counts as the worst
  }
  check_below(worst, worst.value, -limits_.joint_margin);
  at(ArmingCheckId::kJoints) = worst;
}

// Find a motor whose angle is outside the motor's own range by more than joint_margin allows. This
// motor and another motor of its leg are reported as swapped if the angle of each motor fits the
// range of the other motor, with the same joint_margin. The check can only distinguish motors with
// different ranges, for example calves from thighs. If no other motor of the leg fits, the check
// fails only if the angle is outside the motor's own range by kSwapMargin or more.
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
    int partner = -1;
    for (int k = leg; k < leg + kLegJoints; ++k) {
      const double worst_outside = std::max(outside(i, k), outside(k, i));
      if (k == i || !(worst_outside < best)) continue;  // NaN never fits
      best = worst_outside;
      partner = k;
    }
    if (partner < 0 && outside(i, i) < kSwapMargin) continue;
    check.passed = false;
    check.motor = i;
    check.swapped_with = partner;
    check.value = outside(i, i);
    return;
  }
}

void ArmingChecks::check_feet(const LowState& state) noexcept {
  const RobotConfig& config = robot_.config();
  double total = 0.0, max_error = 0.0;
  for (int i = 0; i < kLegs; ++i) total += state.footForceEst[i];
  for (int i = 0; i < kMotors; ++i) {
    max_error = std::max(max_error, std::abs(state.motorState[i].q - config.q_standing[i]));
  }
  ArmingCheck& check = at(ArmingCheckId::kFootForce);
  check_below(check, std::abs(total / (robot_.mass() * kGravity) - 1.0), kFootForceTolerance);
  check.applies = max_error < kStandingTolerance && total != 0.0;
}

}  // namespace surefoot
