// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/contact/foot_clearance.hpp"

#include <algorithm>

namespace surefoot {

namespace {
// Chosen; covered by test_contact.cpp. Bounds below and above:
// [m/s] A slower foot is at rest. Velocity noise of the joints; a foot that is lifted.
constexpr double kRestSpeed = 0.03;
// Motion reduces the time of rest this much faster. One noisy sample must not; 50 ms of motion
// must.
constexpr double kRestTimeDecay = 20.0;
// [s] No foot is lifted and put down faster. Wrong samples (contact_dwell, 10 ms); a step.
constexpr double kMinSwingTime = 0.03;
// [s] Three feet must be loaded this long to form a plane. Bounces at touchdown; delay of the vote.
constexpr double kLandingTime = 0.05;
// [s] of rest before the stance height follows the foot. A foot that a person holds; drift of
// height.
constexpr double kNewStanceTime = 1.0;
// [s] Time constant of following. Vibration; it is reached soon after kNewStanceTime.
constexpr double kFollowTime = 0.2;
constexpr double kStanceConfidence =
    0.5;  // contact confidence of a stance foot: more likely than not
}  // namespace

void FootClearance::update(const Dynamics& dynamics, const InvariantFilter& filter,
                           const FeetMatrix& v_contact, const Eigen::Vector4d& contact,
                           const std::array<bool, kLegs>& loaded, const Vector3& normal,
                           double dt) noexcept {
  // The height estimate of a falling robot drifts while its feet touch down one after the other. So
  // stance heights follow the loaded feet until three of them form a plane.
  const bool plane = std::count(loaded.begin(), loaded.end(), true) >= 3;
  plane_time_ = plane ? plane_time_ + dt : 0.0;
  const bool landing = plane_time_ < kLandingTime;
  Eigen::Vector4d height_change;
  for (int leg = 0; leg < kLegs; ++leg) {
    // The dynamics have the base at the origin, and filter.p() is the IMU point. The offset between
    // the two is treated as constant: only differences of heights are used.
    const double height = normal.dot(dynamics.legs()[leg].p_world_contact) + normal.dot(filter.p());
    // An unloaded foot loses its stance height and gets a new one when it is next loaded.
    unloaded_time_[leg] = loaded[leg] ? 0.0 : unloaded_time_[leg] + dt;
    if (unloaded_time_[leg] > kMinSwingTime) stance_height_[leg] = NAN;
    if ((landing || std::isnan(stance_height_[leg])) && loaded[leg]) stance_height_[leg] = height;
    const bool rests = v_contact.col(leg).norm() < kRestSpeed && loaded[leg];
    rest_time_[leg] = std::clamp(rest_time_[leg] + (rests ? dt : -kRestTimeDecay * dt), 0.0,
                                 1.5 * kNewStanceTime);
    if (rests && rest_time_[leg] > kNewStanceTime)
      stance_height_[leg] += dt / (dt + kFollowTime) * (height - stance_height_[leg]);
    height_change[leg] = std::isnan(stance_height_[leg]) ? 0.0 : height - stance_height_[leg];
  }
  // Height above the plane of the other three feet: errors of base tilt and height cancel there.
  // The mean is a lower bound of the plane's height, because a rise of the diagonal foot lowers the
  // plane here by as much and would look like a rise of this foot.
  for (int leg = 0; leg < kLegs; ++leg) {
    const int lateral = lateral_neighbor(leg), longitudinal = longitudinal_neighbor(leg),
              opposite = diagonal_leg(leg);
    const bool others_stand =
        std::min({contact[lateral], contact[longitudinal], contact[opposite]}) > kStanceConfidence;
    const double plane_height =
        height_change[lateral] + height_change[longitudinal] - height_change[opposite];
    const double mean = (height_change.sum() - height_change[leg]) / 3.0;
    // Unless all other feet stand, the last clearance is kept.
    if (landing || std::isnan(stance_height_[leg])) {
      clearance_[leg] = 0.0;
    } else if (others_stand) {
      clearance_[leg] = height_change[leg] - std::max(plane_height, mean);
    }
  }
}

}  // namespace surefoot
