// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/contact/foot_rise.hpp"

#include <algorithm>

namespace surefoot {

namespace {
constexpr double kRests = 0.03;  // [m/s] slower than this is at rest
constexpr double kAnew = 1.0;    // [s] of rest after which a foot stands where it is
constexpr double kFollow = 0.2;  // [s] in which the place of a foot that stands is followed
constexpr double kStands = 0.5;  // belief
}  // namespace

void FootRise::update(const Dynamics& dynamics, const InvariantFilter& filter,
                      const FeetMatrix& v_contact, const Eigen::Vector4d& contact,
                      const std::array<bool, kLegs>& bears, const Vector3& normal,
                      double dt) noexcept {
  Eigen::Vector4d moved;
  for (int leg = 0; leg < kLegs; ++leg) {
    // Dynamics have the base at the origin; what differs from the filter's point does not move.
    const double height = normal.dot(dynamics.legs()[leg].p_world_contact) + normal.dot(filter.p());
    if (!started_) stood_[leg] = height;
    const bool rests = v_contact.col(leg).norm() < kRests && bears[leg];
    rested_[leg] = rests ? rested_[leg] + dt : 0.0;
    if (rested_[leg] > kAnew) stood_[leg] += dt / (dt + kFollow) * (height - stood_[leg]);
    moved[leg] = height - stood_[leg];
  }
  // FR FL RR RL: beside, before or behind, and across. Out of the plane of the other three, for
  // what a wrong tilt or height of the base makes of four feet cancels there; and of itself, for
  // the foot across leaves its own plane by as much.
  for (int leg = 0; leg < kLegs; ++leg) {
    const int beside = leg ^ 1, along = leg ^ 2, across = leg ^ 3;
    const bool stand = std::min({contact[beside], contact[along], contact[across]}) > kStands;
    const double plane = moved[beside] + moved[along] - moved[across];
    const double mean = (moved.sum() - moved[leg]) / 3.0;
    rise_[leg] = stand ? moved[leg] - std::max(plane, mean) : 0.0;
  }
  started_ = true;
}

}  // namespace surefoot
