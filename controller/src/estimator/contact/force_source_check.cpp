// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/contact/force_source_check.hpp"

#include <algorithm>
#include <cmath>

namespace surefoot {

namespace {
// [s] Before footForceEst counts as working, or as failed. Chosen. Below: impacts and stray samples
// (test_stray_count_does_not_revive_a_dead_foot_force); above: contact by a dead source.
constexpr double kSwitchTime = 0.1;
// Shares of the weight, chosen: standing feet carry 1, lifted feet 0, and a dead sensor shows 0.
constexpr double kUnloadedShare = 0.25;  // a smaller footForceEst contradicts a loaded robot
constexpr double kSupportedShare = 0.5;  // a larger load shows that the feet carry the robot
constexpr double kMaxLoad = 2.0;         // larger loads do not occur in standing
// Shares of the load that the accelerometer implies. Chosen: one foot carries a quarter; between
// the two values the check keeps its verdict.
constexpr double kBalanceTolerance = 0.25;  // largest error of a source that matches
constexpr double kTorqueErrorShare = 0.5;   // smallest error of wrong torques
// [s] Before torques count as wrong, or as right again. Chosen. Below: a push, 0.1 s, during which
// torques and accelerometer differ; above: contact by wrong torques.
constexpr double kDetectionTime = 0.3;
}  // namespace

void ForceSourceCheck::update(const ForceSums& sums, double dt) noexcept {
  const double load_factor = std::max(sums.load_factor, kSupportedShare);
  torques_balance_ =
      std::abs(sums.torque - std::max(sums.load_factor, 0.0)) < kBalanceTolerance * load_factor;
  const bool est_matches = std::abs(sums.est - load_factor) < kBalanceTolerance * load_factor;
  const bool torques_miss = sums.torques && est_matches &&
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
