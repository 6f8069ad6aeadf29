// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "surefoot/safety.hpp"

namespace surefoot {

namespace {

// Counter of the SDK's PowerProtect, measured on the vendor's library: each call with a power above
// the limit raises the counter by one, and each other call lowers it by one.
constexpr int kTripCount = 5;  // the protection trips above this count
constexpr int kMaxCount = 10;  // largest value of the counter
constexpr int kMaxLevel = 10;  // largest level of the SDK's PowerProtect
// [rad] A command with this |q| or more is no position command. Chosen smaller than the SDK's
// PosStopF = 2.146e9, because the vendor's Python examples send other values of that size.
constexpr float kMinPositionOff = 1e9F;

// Compute sum |tauEst dq| [W]. The sum of absolute values propagates NaN and infinity, so the
// caller can check all twelve motors at once.
double motor_power(const LowState& state) noexcept {
  double power = 0.0;
  for (int i = 0; i < kMotors; ++i) {
    const MotorState& motor = state.motorState[i];
    power += std::abs(static_cast<double>(motor.tauEst) * static_cast<double>(motor.dq));
  }
  return power;
}

}  // namespace

Safety::Safety(const Robot& robot)
    : q_lower_(robot.config().q_lower), q_upper_(robot.config().q_upper) {}

int Safety::power_protect(const LowCmd&, const LowState& state, int level) noexcept {
  power_ = motor_power(state);
  const double limit = kWattsPerLevel * std::clamp(level, 1, kMaxLevel);
  const bool within_limit = power_ <= limit;  // false for NaN
  power_counter_ =
      within_limit ? std::max(power_counter_ - 1, 0) : std::min(power_counter_ + 1, kMaxCount);
  return power_counter_ > kTripCount || !std::isfinite(power_) ? -1 : 1;
}

int Safety::position_protect(const LowCmd&, const LowState& state, double limit) noexcept {
  position_motor_ = -1;
  position_angle_ = 0.0;
  for (int i = 0; i < kMotors; ++i) {
    const double q = state.motorState[i].q;
    // Both comparisons are false for NaN. So an angle or a limit that is NaN counts as outside.
    if (q >= q_lower_[i] + limit && q <= q_upper_[i] - limit) continue;
    position_motor_ = i;
    position_angle_ = q;
    return -1;
  }
  return 1;
}

void Safety::position_limit(LowCmd& cmd) const noexcept {
  for (int i = 0; i < kMotors; ++i) {
    const float q = cmd.motorCmd[i].q;
    if (!(std::abs(q) < kMinPositionOff)) continue;
    if (q < q_lower_[i]) cmd.motorCmd[i].q = static_cast<float>(q_lower_[i]);
    if (q > q_upper_[i]) cmd.motorCmd[i].q = static_cast<float>(q_upper_[i]);
  }
}

void Safety::reset() noexcept {
  power_ = 0.0;
  power_counter_ = 0;
  position_motor_ = -1;
  position_angle_ = 0.0;
}

}  // namespace surefoot
