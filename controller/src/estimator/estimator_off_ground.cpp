// SPDX-License-Identifier: BSD-3-Clause
// Estimator of a robot that does not stand: it is carried, hangs or falls.
#include <algorithm>

#include "estimator/estimator_impl.hpp"

namespace surefoot {

namespace {
// Contact confidence above which a foot is in contact. Chosen: half-way between off the ground and
// loaded.
constexpr double kInContact = 0.5;
// [s] Time without contact after which a robot is off the ground. Chosen: longer than the flight of
// a jump of 10 cm (0.29 s).
constexpr double kFlightTime = 0.3;
// [m/s] Standard deviation of the velocity of a body that is carried or hangs. Chosen: a hand that
// accelerates by 2 m/s^2 at 1 Hz moves at 0.3 m/s.
constexpr double kCarriedSpeed = 0.3;
// [s] Time for which this velocity lasts. Chosen: a quarter of a period at 1 Hz.
constexpr double kCarriedTime = 0.25;
}  // namespace

// Refute the contacts that are only assumed if the IMU contradicts them. The feet have then already
// pulled the attitude, so it is restored. While sensors measure the force of every foot, nothing is
// assumed.
void StateEstimator::Impl::check_standing(double dt) noexcept {
  const std::array<bool, kLegs>& assumed = contact.assumed();
  if (std::none_of(assumed.begin(), assumed.end(), [](bool leg) { return leg; })) {
    standing_check.reset();
    attitude_memory.reset();
    return;
  }
  attitude_memory.update(filter, imu_input);
  standing_check.update(dynamics, {assumed, q, w_base, imu_input.f_base, robot.config().p_base_imu},
                        dt);
  if (standing_check.newly_refuted()) attitude_memory.restore(filter, kCarriedSpeed);
}

bool StateEstimator::Impl::off_ground() const noexcept { return air_time > kFlightTime; }

// Off the ground, nothing measures the velocity, so the accelerometer would not correct the tilt.
// But a body that is carried or hangs has a mean velocity of about zero. This velocity is no white
// noise: over its correlation time, as many errors as there are ticks are the same.
void StateEstimator::Impl::correct_off_ground(double dt) noexcept {
  air_time = state.contact.maxCoeff() > kInContact ? 0.0 : air_time + dt;
  if (!off_ground()) return;
  filter.correct_zero_velocity(kCarriedSpeed * kCarriedSpeed * 2.0 * kCarriedTime / dt);
}

}  // namespace surefoot
