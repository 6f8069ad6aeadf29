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
// [s] The same while feet step: a soft sole still slides for 20 to 50 ms, while its
// load grows; on a b1 for up to 80 ms.
constexpr double kSteppingSettlingTime = 0.09;
// [s] Duration of slipping at slip_speed that raises slip() from 0 to 1; a foot that slips faster
// needs less, 3 mm in all. Longer than single samples. If larger: a foot slips further.
constexpr double kDetectionTime = 0.02;
// [s] Duration without slipping that lowers slip() from 1 to 0. If smaller: the friction returns
// within the same push, and the foot slips again. If larger: the friction is still reduced when the
// robot needs it for the next push.
constexpr double kRecoveryTime = 0.5;
// Contact confidence above which a foot counts as loaded. Chosen: half-way between off the ground
// and loaded.
constexpr double kLoadedConfidence = 0.5;
// [m g] Load below which a foot of a stepping robot has no friction to lose. Chosen: a fifth of the
// load of a trotting foot, above the error of the forces from the motor torques.
constexpr double kMinLoad = 0.1;
}  // namespace

void SlipDetector::update(const Gains& gains, const FootSlipInput& input, double dt) noexcept {
  const double settling_time = input.stepping ? kSteppingSettlingTime : kSettlingTime;
  for (int leg = 0; leg < kLegs; ++leg) {
    const Vector3 v = input.v_contact.col(leg);
    const bool in_contact = input.contact[leg] > kLoadedConfidence;
    // The low-pass restarts at touchdown, because the velocity of the swing must not count as slip.
    if (in_contact && stance_time_[leg] == 0.0) v_filtered_.col(leg) = v;
    v_filtered_.col(leg) += dt / (dt + kFilterTime) * (v - v_filtered_.col(leg));
    if (input.stepping && !in_contact) slip_[leg] = 0.0;
    stance_time_[leg] = in_contact ? stance_time_[leg] + dt : 0.0;
    speed_[leg] = v_filtered_.col(leg).norm();
  }
  excess_speed_ = excess(speed_, input);
  const Eigen::Vector4d excess_slip =
      input.stepping ? excess(sliding_speed(input), input) : excess_speed_;
  for (int leg = 0; leg < kLegs; ++leg) {
    const bool loaded = !input.stepping || input.loads[leg] > kMinLoad;
    const bool is_slipping =
        loaded && stance_time_[leg] > settling_time && excess_slip[leg] > gains.slip_speed;
    const double step = is_slipping ? dt / kDetectionTime * excess_slip[leg] / gains.slip_speed
                                    : -dt / kRecoveryTime;
    slip_[leg] = std::clamp(slip_[leg] + step, 0.0, 1.0);
  }
}

Eigen::Vector4d SlipDetector::sliding_speed(const FootSlipInput& input) const noexcept {
  const FeetMatrix v = v_filtered_ - input.normal * (input.normal.transpose() * v_filtered_);
  return v.colwise().norm();
}

Eigen::Vector4d SlipDetector::excess(const Eigen::Vector4d& speed,
                                     const FootSlipInput& input) const noexcept {
  double slowest = std::numeric_limits<double>::infinity();
  for (int leg = 0; leg < kLegs; ++leg) {
    if (input.contact[leg] > kLoadedConfidence) slowest = std::min(slowest, speed[leg]);
  }
  return (speed.array() - slowest).cwiseMax(0.0);
}

}  // namespace surefoot
