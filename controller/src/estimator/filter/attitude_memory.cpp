// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/filter/attitude_memory.hpp"

namespace surefoot {

namespace {
// [s] Age at which the recent entry becomes the old one. Chosen longer than the time in which
// StandingCheck detects a motion, and so short that noise and bias of the gyroscope turn the old
// entry by less than 0.2 deg once the bias is known to 1e-3 rad/s.
constexpr double kInterval = 1.0;
}  // namespace

AttitudeMemory::Entry AttitudeMemory::estimate(const InvariantFilter& filter) noexcept {
  return {filter.quaternion(), filter.gyroscope_bias(), filter.accelerometer_bias()};
}

void AttitudeMemory::update(const InvariantFilter& filter, const ImuInput& imu) noexcept {
  if (!started_) {
    old_ = recent_ = estimate(filter);
    started_ = true;
    return;
  }
  for (Entry* entry : {&old_, &recent_})
    entry->q = (entry->q * exp_so3(imu.dt * (imu.w_base - entry->gyroscope_bias))).normalized();
  age_ += imu.dt;
  if (age_ < kInterval) return;
  old_ = recent_;
  recent_ = estimate(filter);
  age_ = 0.0;
}

void AttitudeMemory::restore(InvariantFilter& filter, double velocity_sigma) const noexcept {
  filter.set_attitude(old_.q, old_.gyroscope_bias, old_.accelerometer_bias, velocity_sigma);
}

}  // namespace surefoot
