// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/contact/field_judge.hpp"

#include <algorithm>
#include <cmath>

namespace surefoot {

namespace {
constexpr double kJudgement = 0.1;  // [s] before the field is believed, or no longer
constexpr double kDenying = 0.25;   // share of the weight below which the field denies the load
constexpr double kCarrying = 0.5;   // share of the weight that shows the robot is carried
constexpr double kMost = 2.0;       // more than that no robot that stands weighs
constexpr double kBears = 0.25;     // share of what is felt that a field which bears it may miss
constexpr double kMisses = 0.5;     // share of what is felt that wrong torques miss
constexpr double kPatience = 0.3;   // [s] before torques are called wrong, or right again
}  // namespace

void FieldJudge::update(const FieldSums& sums, double dt) noexcept {
  const double felt = std::max(sums.felt, kCarrying);
  torques_balance_ = std::abs(sums.torque - std::max(sums.felt, 0.0)) < kBears * felt;
  const bool bears = std::abs(sums.est - felt) < kBears * felt;
  const bool misses = sums.torques && bears && std::abs(sums.torque - felt) > kMisses * felt;
  torque_doubt_ = std::clamp(torque_doubt_ + (misses ? dt : -dt), 0.0, kPatience);
  if (torque_doubt_ >= kPatience) torques_wrong_ = true;
  if (torque_doubt_ <= 0.0) torques_wrong_ = false;

  const bool torques = sums.torques && !torques_wrong_;
  const bool carried = torques ? sums.torque > kCarrying : sums.est < kMost;
  const bool contradicted = est_alive_ ? torques && carried && !misses && sums.est < kDenying
                                       : carried && sums.est > kCarrying;
  est_doubt_ = contradicted ? est_doubt_ + dt : 0.0;
  if (est_doubt_ > kJudgement) {
    est_alive_ = !est_alive_;
    est_doubt_ = 0.0;
  }
}

}  // namespace surefoot
