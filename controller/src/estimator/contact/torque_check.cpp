// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/contact/torque_check.hpp"

namespace surefoot {

namespace {
// [s] The verdict is kConstant if tauEst is constant for longer than this while other fields
// change. Chosen equal to kStuckTime in contact_evidence.cpp.
constexpr double kStuckTime = 0.1;
}  // namespace

// If all twelve torques are exactly zero, the robot does not send torques: verdict kZero.
void TorqueCheck::update(const Vector12& tau_est, bool others_changed, double dt) noexcept {
  const bool unchanged = tau_est == last_tau_;
  unchanged_time_ = unchanged ? unchanged_time_ + (others_changed ? dt : 0.0) : 0.0;
  last_tau_ = tau_est;
  if (tau_est.isZero(0.0)) {
    verdict_ = SensorVerdict::kZero;
  } else {
    verdict_ = unchanged_time_ > kStuckTime ? SensorVerdict::kConstant : SensorVerdict::kGood;
  }
}

}  // namespace surefoot
