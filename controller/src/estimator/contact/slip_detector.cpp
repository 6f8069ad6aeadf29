// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/contact/slip_detector.hpp"

#include <algorithm>

namespace surefoot {

namespace {
constexpr double kSmooth = 0.01;   // [s] of the speeds
constexpr double kCertain = 0.02;  // [s] of sliding until it is sure
constexpr double kRecovery = 0.5;  // [s] at rest until it is over
constexpr double kLoaded = 0.5;    // belief of a foot that can slip
}  // namespace

void SlipDetector::update(const Gains& gains, const FeetMatrix& v_contact,
                          const Eigen::Vector4d& contact, double dt) noexcept {
  v_ += dt / (dt + kSmooth) * (v_contact - v_);
  double slowest = std::numeric_limits<double>::infinity();
  for (int leg = 0; leg < kLegs; ++leg) {
    speed_[leg] = v_.col(leg).norm();
    if (contact[leg] > kLoaded) slowest = std::min(slowest, speed_[leg]);
  }
  for (int leg = 0; leg < kLegs; ++leg) {
    excess_[leg] = std::max(speed_[leg] - slowest, 0.0);
    const bool slips = contact[leg] > kLoaded && excess_[leg] > gains.slip_speed;
    const double step = slips ? dt / kCertain : -dt / kRecovery;
    slip_[leg] = std::clamp(slip_[leg] + step, 0.0, 1.0);
  }
}

}  // namespace surefoot
