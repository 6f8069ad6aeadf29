// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/contact/foot_rise.hpp"

#include <algorithm>

namespace surefoot {

namespace {
constexpr double kRests = 0.03;  // [m/s] slower than this is at rest
constexpr double kLeak = 20.0;   // times faster than rest adds up does motion wipe it out
constexpr double kSwing = 0.03;  // [s] no foot is lifted and put down faster
constexpr double kLands = 0.05;  // [s] for which three feet bear before they make a plane
constexpr double kAnew = 1.0;    // [s] of rest after which a foot stands where it is
constexpr double kFollow = 0.2;  // [s] in which the place of a foot that stands is followed
constexpr double kStands = 0.5;  // belief
}  // namespace

void FootRise::update(const Dynamics& dynamics, const InvariantFilter& filter,
                      const FeetMatrix& v_contact, const Eigen::Vector4d& contact,
                      const std::array<bool, kLegs>& bears, const Vector3& normal,
                      double dt) noexcept {
  // The height at which a falling robot is believed drifts, so feet that touch down one after the
  // other stand where they do only once there is a plane to rise from.
  const bool plane = std::count(bears.begin(), bears.end(), true) >= 3;
  plane_ = plane ? plane_ + dt : 0.0;
  const bool lands = plane_ < kLands;
  Eigen::Vector4d moved;
  for (int leg = 0; leg < kLegs; ++leg) {
    // Dynamics have the base at the origin; what differs from the filter's point does not move.
    const double height = normal.dot(dynamics.legs()[leg].p_world_contact) + normal.dot(filter.p());
    // A foot that its forces call lifted stands nowhere; where it next bears load it stands anew.
    unborne_[leg] = bears[leg] ? 0.0 : unborne_[leg] + dt;
    if (unborne_[leg] > kSwing) stood_[leg] = NAN;
    if ((lands || std::isnan(stood_[leg])) && bears[leg]) stood_[leg] = height;
    const bool rests = v_contact.col(leg).norm() < kRests && bears[leg];
    rested_[leg] = std::clamp(rested_[leg] + (rests ? dt : -kLeak * dt), 0.0, 1.5 * kAnew);
    if (rests && rested_[leg] > kAnew) stood_[leg] += dt / (dt + kFollow) * (height - stood_[leg]);
    moved[leg] = std::isnan(stood_[leg]) ? 0.0 : height - stood_[leg];
  }
  // FR FL RR RL: beside, before or behind, and across. Out of the plane of the other three, for
  // what a wrong tilt or height of the base makes of four feet cancels there; and of itself, for
  // the foot across leaves its own plane by as much.
  for (int leg = 0; leg < kLegs; ++leg) {
    const int beside = other_side(leg), along = other_end(leg), across = diagonal(leg);
    const bool stand = std::min({contact[beside], contact[along], contact[across]}) > kStands;
    const double level = moved[beside] + moved[along] - moved[across];
    const double mean = (moved.sum() - moved[leg]) / 3.0;
    // While the others do not all stand nothing new is known.
    if (lands || std::isnan(stood_[leg])) {
      rise_[leg] = 0.0;
    } else if (stand) {
      rise_[leg] = moved[leg] - std::max(level, mean);
    }
  }
}

}  // namespace surefoot
