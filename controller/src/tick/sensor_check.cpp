// SPDX-License-Identifier: BSD-3-Clause
#include "tick/sensor_check.hpp"

namespace surefoot {

SensorCheck::SensorCheck(const Robot& robot)
    : robot_(robot), first_samples_(robot.config()), torque_gain_(robot.config().tau_max) {}

void SensorCheck::reset() noexcept {
  first_samples_.reset();
  torque_gain_.reset();
  motion_.reset();
  found_ = Status::kOk;
}

Status SensorCheck::update(const LowState& low_state, Status estimated,
                           const StateEstimator& estimator, const Vector12* commanded,
                           bool feet_stand, double dt) noexcept {
  if (ended_ || found_ != Status::kOk) return found_;
  const bool usable = estimated == Status::kOk;
  if (!first_samples_.done()) {
    found_ = first_samples_.update(low_state, estimated, estimator, dt);
  }
  if (usable && found_ == Status::kOk && commanded != nullptr && !torque_gain_.done()) {
    found_ = torque_gain_.update(low_state, *commanded, dt);
  }
  // A motion computed from joint angles that may be wrong proves nothing.
  if (usable && found_ == Status::kOk && !motion_.done() &&
      !first_samples_.suspects_joint_angles()) {
    found_ = motion_.update(low_state, robot_.config(), estimator, feet_stand, dt);
  }
  return found_;
}

}  // namespace surefoot
