// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/contact/force_source_check.hpp"

#include <algorithm>
#include <cmath>

namespace surefoot {

namespace {
constexpr double kSwitchTime = 0.1;  // [s] before the field is believed, or no longer
constexpr double kUnloadedShare =
    0.25;  // share of the weight below which the field denies the load
constexpr double kSupportedShare = 0.5;  // share of the weight that shows the robot is carried
constexpr double kMaxLoad = 2.0;         // more than that no robot that stands weighs
constexpr double kBalanceTolerance =
    0.25;  // share of what is felt that a field which bears it may miss
constexpr double kTorqueErrorShare = 0.5;  // share of what is felt that wrong torques miss
constexpr double kDetectionTime = 0.3;     // [s] before torques are called wrong, or right again
}  // namespace

void ForceSourceCheck::update(const ForceSums& sums, double dt) noexcept {
  const double load_factor = std::max(sums.load_factor, kSupportedShare);
  torques_balance_ =
      std::abs(sums.torque - std::max(sums.load_factor, 0.0)) < kBalanceTolerance * load_factor;
  const bool bears = std::abs(sums.est - load_factor) < kBalanceTolerance * load_factor;
  const bool torques_miss = sums.torques && bears &&
                            std::abs(sums.torque - load_factor) > kTorqueErrorShare * load_factor;
  torque_error_time_ =
      std::clamp(torque_error_time_ + (torques_miss ? dt : -dt), 0.0, kDetectionTime);
  if (torque_error_time_ >= kDetectionTime) torques_wrong_ = true;
  if (torque_error_time_ <= 0.0) torques_wrong_ = false;

  const bool torques = sums.torques && !torques_wrong_;
  const bool supported = torques ? sums.torque > kSupportedShare : sums.est < kMaxLoad;
  const bool contradicted = foot_force_est_alive_
                                ? torques && supported && !torques_miss && sums.est < kUnloadedShare
                                : supported && sums.est > kSupportedShare;
  est_contradiction_time_ = contradicted ? est_contradiction_time_ + dt : 0.0;
  if (est_contradiction_time_ > kSwitchTime) {
    foot_force_est_alive_ = !foot_force_est_alive_;
    est_contradiction_time_ = 0.0;
  }
}

}  // namespace surefoot
