// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/contact/foot_clearance.hpp"

#include <algorithm>

namespace surefoot {

namespace {
// All values are chosen. Test: test_contact.cpp.
// [m/s] Speed below which a foot is at rest. Larger than the velocity noise of the joints, smaller
// than the speed of a lifted foot.
constexpr double kRestSpeed = 0.03;
// [s/s] Rate at which rest_time_ falls during motion; at rest it rises at rate 1. If smaller: 50 ms
// of motion do not clear a rest time of 1 s. If larger: one noisy sample clears the rest time.
constexpr double kRestTimeDecay = 20.0;
// [s] A foot loses its stance height after it has been unloaded for this time. Longer than a few
// wrong samples (contact_dwell, 10 ms), shorter than a step.
constexpr double kMinSwingTime = 0.03;
// [s] Three feet must be loaded for this time before they form a plane. If smaller: feet that
// bounce at touchdown form a plane. If larger: a lift right after a landing is detected later.
constexpr double kLandingTime = 0.05;
// [s] The stance height follows a foot that has been at rest for this time. If smaller: the height
// follows a foot that a person holds. If larger: drift of the height remains for longer.
constexpr double kNewStanceTime = 1.0;
// [s] Time constant with which the stance height follows the foot. If smaller: the height follows
// vibration. Shorter than kNewStanceTime.
constexpr double kFollowTime = 0.2;
// Contact confidence above which a foot stands. Chosen: half-way between off the ground and loaded.
constexpr double kStanceConfidence = 0.5;
}  // namespace

void FootClearance::update(const Dynamics& dynamics, const InvariantFilter& filter,
                           const FeetMatrix& v_contact, const Eigen::Vector4d& contact,
                           const std::array<bool, kLegs>& loaded, const Vector3& normal,
                           double dt) noexcept {
  // The estimated height of a falling robot drifts while its feet touch down one after the other.
  // So the stance heights follow the loaded feet until three loaded feet form a plane.
  const bool three_loaded = std::count(loaded.begin(), loaded.end(), true) >= 3;
  plane_time_ = three_loaded ? plane_time_ + dt : 0.0;
  const bool landing = plane_time_ < kLandingTime;
  Eigen::Vector4d height_change;
  for (int leg = 0; leg < kLegs; ++leg) {
    // The dynamics place the base at the origin, but filter.p() is the IMU point. The height of the
    // IMU point above the base is taken as constant, because only height differences are used.
    const double height = normal.dot(dynamics.legs()[leg].p_world_contact) + normal.dot(filter.p());
    // A foot without load loses its stance height. It gets a new one when it is loaded again.
    unloaded_time_[leg] = loaded[leg] ? 0.0 : unloaded_time_[leg] + dt;
    if (unloaded_time_[leg] > kMinSwingTime) stance_height_[leg] = NAN;
    if ((landing || std::isnan(stance_height_[leg])) && loaded[leg]) stance_height_[leg] = height;
    // The upper bound of the rest time is chosen: from this bound, 25 ms of motion bring the rest
    // time below kNewStanceTime (0.5 kNewStanceTime / kRestTimeDecay).
    const bool at_rest = v_contact.col(leg).norm() < kRestSpeed && loaded[leg];
    rest_time_[leg] = std::clamp(rest_time_[leg] + (at_rest ? dt : -kRestTimeDecay * dt), 0.0,
                                 1.5 * kNewStanceTime);
    if (at_rest && rest_time_[leg] > kNewStanceTime)
      stance_height_[leg] += dt / (dt + kFollowTime) * (height - stance_height_[leg]);
    height_change[leg] = std::isnan(stance_height_[leg]) ? 0.0 : height - stance_height_[leg];
  }
  // The clearance is the height change of a foot, relative to the plane through the height changes
  // of the three other feet; errors of base tilt and height cancel in this difference. But if the
  // diagonal foot rises, this plane falls by the same amount at the present foot, which would look
  // like a rise of the present foot. So the plane counts as at least as high as the mean height
  // change of the three other feet.
  for (int leg = 0; leg < kLegs; ++leg) {
    const int lateral = lateral_neighbor(leg), longitudinal = longitudinal_neighbor(leg),
              opposite = diagonal_leg(leg);
    const bool others_stand =
        std::min({contact[lateral], contact[longitudinal], contact[opposite]}) > kStanceConfidence;
    const double plane_height =
        height_change[lateral] + height_change[longitudinal] - height_change[opposite];
    const double mean_change = (height_change.sum() - height_change[leg]) / 3.0;
    // The last clearance is kept while any of the three other feet does not stand.
    if (landing || std::isnan(stance_height_[leg])) {
      clearance_[leg] = 0.0;
    } else if (others_stand) {
      clearance_[leg] = height_change[leg] - std::max(plane_height, mean_change);
    }
  }
}

}  // namespace surefoot
