// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/contact/slip_detector.hpp"

#include <algorithm>
#include <limits>

namespace surefoot {

namespace {
// Chosen times; docs/estimation.md, Slip; covered by test_contact.cpp.
// [s] Low-pass of the velocities. Below: encoder noise; above: kDetectionTime.
constexpr double kFilterTime = 0.01;
// [s] After touchdown, in which a foot may still move. Below: contact_dwell, 10 ms; above: the
// robot relies on the friction of a foot that slips.
constexpr double kSettlingTime = 0.03;
// [s] of slipping in which slip() rises from 0 to 1. Below: single samples; above: a foot at
// slip_speed moves by 3 mm in it.
constexpr double kDetectionTime = 0.02;
// [s] without slipping in which it falls from 1 to 0. Below: friction that returns within a push
// slips again; above: the robot needs the friction for the next push.
constexpr double kRecoveryTime = 0.5;
constexpr double kLoadedConfidence =
    0.5;  // contact confidence of a loaded foot: more likely than not
}  // namespace

void SlipDetector::update(const Gains& gains, const FeetMatrix& v_contact,
                          const Eigen::Vector4d& contact, double dt) noexcept {
  for (int leg = 0; leg < kLegs; ++leg) {
    const bool loaded = contact[leg] > kLoadedConfidence;
    // The velocity of the swing must not count as slip, so the low-pass restarts at touchdown.
    if (loaded && stance_time_[leg] == 0.0) v_filtered_.col(leg) = v_contact.col(leg);
    v_filtered_.col(leg) += dt / (dt + kFilterTime) * (v_contact.col(leg) - v_filtered_.col(leg));
    stance_time_[leg] = loaded ? stance_time_[leg] + dt : 0.0;
  }
  double slowest = std::numeric_limits<double>::infinity();
  for (int leg = 0; leg < kLegs; ++leg) {
    speed_[leg] = v_filtered_.col(leg).norm();
    if (contact[leg] > kLoadedConfidence) slowest = std::min(slowest, speed_[leg]);
  }
  for (int leg = 0; leg < kLegs; ++leg) {
    excess_speed_[leg] = std::max(speed_[leg] - slowest, 0.0);
    const bool slips = stance_time_[leg] > kSettlingTime && excess_speed_[leg] > gains.slip_speed;
    const double step = slips ? dt / kDetectionTime : -dt / kRecoveryTime;
    slip_[leg] = std::clamp(slip_[leg] + step, 0.0, 1.0);
  }
}

}  // namespace surefoot
