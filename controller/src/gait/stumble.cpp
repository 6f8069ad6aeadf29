// SPDX-License-Identifier: BSD-3-Clause
#include "gait/stumble.hpp"

#include <algorithm>

namespace surefoot {

namespace {

// [sqrt(h/g)] Time of a lift: 0.22 s at h = 0.3 m. Chosen: that of a usual swing.
constexpr double kTime = 1.25;
// [h] Height of a lift: 11 cm at h = 0.3 m. Chosen: more than the highest step that the robot can
// climb without seeing it.
constexpr double kHeight = 0.36;
// [h] Distance by which a lift begins behind the obstacle. Chosen: a rising foot then does not rub.
constexpr double kRetract = 0.05;
// Share of a lift in which the foot goes straight up, and share from which it may land.
constexpr double kRise = 0.3, kEarliestLanding = 0.5;
// Share of a scheduled swing before which contacts are those of the lift-off.
constexpr double kEarliestStumble = 0.2;
// Contact confidence above which a foot touches something. A foot bounces off a face within 10 ms.
constexpr double kTouched = 0.5;
constexpr double kFree = 0.3;  // contact confidence below which a foot has left the ground
// Most lifts in a swing. Chosen: a foot that is still stopped then stands where it is.
constexpr int kMaxLifts = 2;

}  // namespace

void Stumble::start() noexcept { *this = Stumble(size_); }

void Stumble::end(int leg) noexcept {
  lifting_[leg] = begins_[leg] = free_[leg] = touched_[leg] = false;
  lifts_[leg] = 0;
}

double Stumble::update(int leg, const SwingFoot& foot, double progress, double dt) noexcept {
  const SwingContact judged = judge_swing_contact(foot, size_);
  begins_[leg] = false;
  if (lifting_[leg]) progress_[leg] += dt / time();
  // After a push, saturated motors leave a foot behind its reference too; it then touches nothing.
  free_[leg] = free_[leg] || foot.contact < kFree;
  touched_[leg] =
      touched_[leg] || (free_[leg] && foot.contact > kTouched && may_stumble(leg, progress));
  if (judged == SwingContact::kObstacle && touched_[leg]) {
    const Eigen::Vector2d ahead = foot.v_reference.head<2>().normalized();
    p_start_[leg] << foot.p.head<2>() - kRetract * size_.height * ahead, foot.p.z();
    progress_[leg] = 0.0;
    lifting_[leg] = begins_[leg] = true;
    touched_[leg] = false;
    ++lifts_[leg];
  }
  const bool may_land = !lifting_[leg] || progress_[leg] > kEarliestLanding;
  const bool landed = judged == SwingContact::kGround && may_land;
  if (landed || progress_[leg] >= 1.0) lifting_[leg] = false;
  return landed ? foot.contact : 0.0;
}

bool Stumble::may_stumble(int leg, double progress) const noexcept {
  if (lifts_[leg] >= kMaxLifts) return false;
  return lifting_[leg] ? progress_[leg] > kRise : progress > kEarliestStumble;
}

bool Stumble::any() const noexcept {
  return std::any_of(lifting_.begin(), lifting_.end(), [](bool lifting) { return lifting; });
}

double Stumble::time() const noexcept { return kTime * size_.time; }
double Stumble::longest_time() const noexcept { return kMaxLifts * time(); }
double Stumble::time_left(int leg) const noexcept {
  return std::max(1.0 - progress_[leg], 0.0) * time();
}
bool Stumble::rises(int leg) const noexcept { return progress_[leg] < kRise; }
double Stumble::height() const noexcept { return kHeight * size_.height; }

}  // namespace surefoot
