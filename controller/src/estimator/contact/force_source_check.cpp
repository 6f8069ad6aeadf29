// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/contact/force_source_check.hpp"

#include <algorithm>
#include <cmath>

namespace surefoot {

namespace {
// [s] The verdict on footForceEst changes between working and failed after the sums have
// contradicted the present verdict for this time. Chosen. If smaller: impacts and stray samples
// change the verdict (test_stray_count_does_not_revive_a_dead_foot_force). If larger: a dead source
// influences the contact confidence for longer.
constexpr double kSwitchTime = 0.1;
// Limits of the sum of the loads, as shares of the weight. Chosen: the sum is 1 for a standing
// robot, and 0 for a lifted robot or a dead sensor.
constexpr double kUnloadedShare = 0.25;  // below: footForceEst shows no load
constexpr double kSupportedShare = 0.5;  // above: the feet carry the robot
constexpr double kMaxLoad = 2.0;         // above: impossible while standing
// Limits of the error of a sum, as shares of the load that the accelerometer implies. Chosen: one
// foot of four carries a quarter. Between the two limits the sum is neither right nor wrong.
constexpr double kBalanceTolerance = 0.25;  // below: the sum matches the accelerometer
constexpr double kTorqueErrorShare = 0.5;   // above: the torques are wrong
// [s] Torques count as wrong after an error of this duration, and as right again after the same
// time without error. Chosen. Longer than a push of 0.1 s, during which torques and accelerometer
// differ. If larger: wrong torques influence the contact confidence for longer.
constexpr double kDetectionTime = 0.3;
}  // namespace

void ForceSourceCheck::update(const ForceSums& sums, double dt) noexcept {
  const double load_factor = std::max(sums.load_factor, kSupportedShare);
  torques_balance_ =
      std::abs(sums.torque - std::max(sums.load_factor, 0.0)) < kBalanceTolerance * load_factor;
  const bool est_matches =
      std::abs(sums.foot_force_est - load_factor) < kBalanceTolerance * load_factor;
  const bool torques_miss = sums.has_torques && est_matches &&
                            std::abs(sums.torque - load_factor) > kTorqueErrorShare * load_factor;
  torque_error_time_ =
      std::clamp(torque_error_time_ + (torques_miss ? dt : -dt), 0.0, kDetectionTime);
  if (torque_error_time_ >= kDetectionTime) torques_wrong_ = true;
  if (torque_error_time_ <= 0.0) torques_wrong_ = false;

  const bool has_torques = sums.has_torques && !torques_wrong_;
  const bool supported =
      has_torques ? sums.torque > kSupportedShare : sums.foot_force_est < kMaxLoad;
  const bool contradicted =
      foot_force_est_works_
          ? has_torques && supported && !torques_miss && sums.foot_force_est < kUnloadedShare
          : supported && sums.foot_force_est > kSupportedShare;
  est_contradiction_time_ = contradicted ? est_contradiction_time_ + dt : 0.0;
  if (est_contradiction_time_ > kSwitchTime) {
    foot_force_est_works_ = !foot_force_est_works_;
    est_contradiction_time_ = 0.0;
  }
}

}  // namespace surefoot
