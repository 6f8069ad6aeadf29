// SPDX-License-Identifier: BSD-3-Clause
#include "gait/swing_contact.hpp"

namespace surefoot {

namespace {

constexpr double kTouched = 0.7;  // contact confidence above which a foot touches something
// Share of the reference speed below which a foot is stopped. Chosen: a foot that slides along a
// face keeps more of its speed down, and loses all of its speed ahead.
constexpr double kStoppedAhead = 0.3, kStoppedDown = 0.5;
// [sqrt(g h)] Reference speed ahead below which a foot cannot be judged as stopped: 0.4 m/s at
// h = 0.3 m. Chosen: feet that lift off are slower.
constexpr double kMinSpeed = 0.25;
// [h] Distance behind the reference from which a slow foot is stopped: 1.6 cm at h = 0.3 m.
// Measured: on flat ground a foot is at most 0.038 h behind, at 1.4 m/s (go1).
constexpr double kBehind = 0.055;
// [h] Height of a descending foot below which it lands, whatever stops it: 1.8 cm at h = 0.3 m.
// Chosen: friction stops a foot ahead before a soft sole stops it on its way down.
constexpr double kLow = 0.06;

}  // namespace

SwingContact judge_swing_contact(const SwingFoot& foot, const GaitSize& size) noexcept {
  const bool touched = foot.contact > kTouched, descends = foot.v_reference.z() < 0.0;
  const bool low = descends && foot.height < kLow * size.height;
  if (touched && (low || (descends && foot.v.z() > kStoppedDown * foot.v_reference.z()))) {
    return SwingContact::kGround;
  }
  if (low) return SwingContact::kNone;
  const Eigen::Vector2d v = foot.v_reference.head<2>();
  const double speed = v.norm();
  if (speed < kMinSpeed * size.speed) return SwingContact::kNone;
  if (foot.v.head<2>().dot(v) > kStoppedAhead * speed * speed) return SwingContact::kNone;
  const double behind = (foot.p_reference - foot.p).head<2>().dot(v) / speed;
  return touched || behind > kBehind * size.height ? SwingContact::kObstacle : SwingContact::kNone;
}

}  // namespace surefoot
