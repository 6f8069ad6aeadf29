// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/contact/slip_detector.hpp"

#include <algorithm>
#include <limits>

namespace surefoot {

namespace {
constexpr double kSmooth = 0.01;    // [s] of the speeds
constexpr double kSettling = 0.03;  // [s] from touchdown on in which a foot may come to rest
constexpr double kCertain = 0.02;   // [s] of sliding until it is sure
constexpr double kRecovery = 0.5;   // [s] at rest until it is over
constexpr double kLoaded = 0.5;     // belief of a foot that can slip
}  // namespace

void SlipDetector::update(const Gains& gains, const FeetMatrix& v_contact,
                          const Eigen::Vector4d& contact, double dt) noexcept {
  for (int leg = 0; leg < kLegs; ++leg) {
    const bool loaded = contact[leg] > kLoaded;
    // A swing's speed is not a slip's: smoothing begins anew, and settles, at touchdown.
    if (loaded && down_[leg] == 0.0) v_.col(leg) = v_contact.col(leg);
    v_.col(leg) += dt / (dt + kSmooth) * (v_contact.col(leg) - v_.col(leg));
    down_[leg] = loaded ? down_[leg] + dt : 0.0;
  }
  double slowest = std::numeric_limits<double>::infinity();
  for (int leg = 0; leg < kLegs; ++leg) {
    speed_[leg] = v_.col(leg).norm();
    if (contact[leg] > kLoaded) slowest = std::min(slowest, speed_[leg]);
  }
  for (int leg = 0; leg < kLegs; ++leg) {
    excess_[leg] = std::max(speed_[leg] - slowest, 0.0);
    const bool slips = down_[leg] > kSettling && excess_[leg] > gains.slip_speed;
    const double step = slips ? dt / kCertain : -dt / kRecovery;
    slip_[leg] = std::clamp(slip_[leg] + step, 0.0, 1.0);
  }
}

}  // namespace surefoot
