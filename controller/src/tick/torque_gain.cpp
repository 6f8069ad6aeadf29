// SPDX-License-Identifier: BSD-3-Clause
#include "tick/torque_gain.hpp"

namespace surefoot {

Status TorqueGain::update(const LowState& low_state, const Vector12& commanded,
                          double dt) noexcept {
  Vector12 tau_est;
  for (int i = 0; i < kMotors; ++i) tau_est[i] = low_state.motorState[i].tauEst;
  // A robot without this field sends exact zeros; the estimator then uses the commanded torques.
  if (tau_est.isZero(0.0)) return Status::kOk;
  const Vector12 scaled = commanded.cwiseProduct(scale_);
  product_ += tau_est.cwiseProduct(scale_).dot(scaled);
  square_ += scaled.squaredNorm();
  time_ += dt;
  const bool in_range = product_ > kMinGain * square_ && product_ < kMaxGain * square_;
  done_ = time_ >= (in_range ? kMinTime : kMaxTime);
  return done_ && !in_range ? Status::kWrongJointTorques : Status::kOk;
}

}  // namespace surefoot
