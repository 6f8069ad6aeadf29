// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/contact/slip_detector.hpp"

#include <algorithm>
#include <limits>

namespace surefoot {

namespace {
// All values are chosen; see docs/explanation/estimator.md, Slip. Test: test_contact.cpp.
// [s] Time constant of the low-pass of the velocities. If smaller: the velocities contain the
// encoder noise. Shorter than kDetectionTime.
constexpr double kFilterTime = 0.01;
// [s] Time after touchdown for which a moving foot does not count as slipping. Longer than
// contact_dwell, 10 ms. If larger: the robot relies for longer on the friction of a slipping foot.
constexpr double kSettlingTime = 0.03;
// [s] Duration of slipping that raises slip() from 0 to 1. Longer than single samples. If larger: a
// foot slips further; at slip_speed it moves by 3 mm in this time.
constexpr double kDetectionTime = 0.02;
// [s] Duration without slipping that lowers slip() from 1 to 0. If smaller: the friction returns
// within the same push, and the foot slips again. If larger: the friction is still reduced when the
// robot needs it for the next push.
constexpr double kRecoveryTime = 0.5;
// Contact confidence above which a foot counts as loaded. Chosen: half-way between off the ground
// and loaded.
constexpr double kLoadedConfidence = 0.5;
}  // namespace

void SlipDetector::update(const Gains& gains, const FeetMatrix& v_contact,
                          const Eigen::Vector4d& contact, bool stepping, double dt) noexcept {
  for (int leg = 0; leg < kLegs; ++leg) {
    const bool loaded = contact[leg] > kLoadedConfidence;
    // The low-pass restarts at touchdown, because the velocity of the swing must not count as slip.
    if (loaded && stance_time_[leg] == 0.0) v_filtered_.col(leg) = v_contact.col(leg);
    v_filtered_.col(leg) += dt / (dt + kFilterTime) * (v_contact.col(leg) - v_filtered_.col(leg));
    if (stepping && !loaded) slip_[leg] = 0.0;
    stance_time_[leg] = loaded ? stance_time_[leg] + dt : 0.0;
  }
  double min_loaded_speed = std::numeric_limits<double>::infinity();
  for (int leg = 0; leg < kLegs; ++leg) {
    speed_[leg] = v_filtered_.col(leg).norm();
    if (contact[leg] > kLoadedConfidence)
      min_loaded_speed = std::min(min_loaded_speed, speed_[leg]);
  }
  for (int leg = 0; leg < kLegs; ++leg) {
    excess_speed_[leg] = std::max(speed_[leg] - min_loaded_speed, 0.0);
    const bool is_slipping =
        stance_time_[leg] > kSettlingTime && excess_speed_[leg] > gains.slip_speed;
    const double step = is_slipping ? dt / kDetectionTime : -dt / kRecoveryTime;
    slip_[leg] = std::clamp(slip_[leg] + step, 0.0, 1.0);
  }
}

}  // namespace surefoot
