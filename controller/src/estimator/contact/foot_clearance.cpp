// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/contact/foot_clearance.hpp"

#include <algorithm>

namespace surefoot {

namespace {
constexpr double kRestSpeed = 0.03;      // [m/s] slower than this is at rest
constexpr double kRestTimeDecay = 20.0;  // times faster than rest adds up does motion wipe it out
constexpr double kMinSwingTime = 0.03;   // [s] no foot is lifted and put down faster
constexpr double kLandingTime = 0.05;    // [s] for which three feet bear before they make a plane
constexpr double kNewStanceTime = 1.0;   // [s] of rest after which a foot stands where it is
constexpr double kFollowTime = 0.2;      // [s] in which the place of a foot that stands is followed
constexpr double kStanceConfidence = 0.5;  // belief
}  // namespace

void FootClearance::update(const Dynamics& dynamics, const InvariantFilter& filter,
                           const FeetMatrix& v_contact, const Eigen::Vector4d& contact,
                           const std::array<bool, kLegs>& loaded, const Vector3& normal,
                           double dt) noexcept {
  // The height at which a falling robot is believed drifts, so feet that touch down one after the
  // other stand where they do only once there is a plane to rise from.
  const bool plane = std::count(loaded.begin(), loaded.end(), true) >= 3;
  plane_time_ = plane ? plane_time_ + dt : 0.0;
  const bool landing = plane_time_ < kLandingTime;
  Eigen::Vector4d height_change;
  for (int leg = 0; leg < kLegs; ++leg) {
    // Dynamics have the base at the origin; what differs from the filter's point does not move.
    const double height = normal.dot(dynamics.legs()[leg].p_world_contact) + normal.dot(filter.p());
    // A foot that its forces call lifted stands nowhere; where it next bears load it stands anew.
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
  // FR FL RR RL: beside, before or behind, and across. Out of the plane of the other three, for
  // what a wrong tilt or height of the base makes of four feet cancels there; and of itself, for
  // the foot across leaves its own plane by as much.
  for (int leg = 0; leg < kLegs; ++leg) {
    const int lateral = lateral_neighbor(leg), longitudinal = longitudinal_neighbor(leg),
              opposite = diagonal_leg(leg);
    const bool others_stand =
        std::min({contact[lateral], contact[longitudinal], contact[opposite]}) > kStanceConfidence;
    const double plane_height =
        height_change[lateral] + height_change[longitudinal] - height_change[opposite];
    const double mean = (height_change.sum() - height_change[leg]) / 3.0;
    // While the others do not all stand nothing new is known.
    if (landing || std::isnan(stance_height_[leg])) {
      clearance_[leg] = 0.0;
    } else if (others_stand) {
      clearance_[leg] = height_change[leg] - std::max(plane_height, mean);
    }
  }
}

}  // namespace surefoot
