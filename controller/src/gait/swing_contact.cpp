// SPDX-License-Identifier: BSD-3-Clause
#include "gait/swing_contact.hpp"

namespace surefoot {

namespace {

constexpr double kTouched = 0.7;  // contact confidence above which a foot touches something
// Share of the reference speed below which a foot is stopped ahead. Chosen: a foot that catches up
// with its reference is faster.
constexpr double kStopped = 0.3;
// [sqrt(g h)] Reference speed ahead below which a foot cannot be judged as stopped: 0.4 m/s at
// h = 0.3 m. Chosen: feet that lift off or land are slower.
constexpr double kMinSpeed = 0.25;
// [h] Distance behind the reference from which a slow foot is stopped: 1.6 cm at h = 0.3 m.
// Measured: on flat ground a foot is at most 0.038 h behind, at 1.4 m/s (go1).
constexpr double kBehind = 0.055;
// [h] Distance above the reference from which a descending foot is stopped on its way down: 8 mm at
// h = 0.3 m. Measured: on flat ground a foot is at most 0.015 h above.
constexpr double kAbove = 0.025;
// [h] Height of a descending foot below which it lands, whatever stops it: 1.8 cm at h = 0.3 m.
// Chosen: friction stops a foot ahead before a soft sole stops it on its way down.
constexpr double kLow = 0.06;

}  // namespace

SwingContact judge_swing_contact(const SwingFoot& foot, const GaitSize& size) noexcept {
  const Vector3 lag = foot.p_reference - foot.p;
  if (foot.v_reference.z() < 0.0) {
    const bool low = foot.height < kLow * size.height;
    const bool lands = low || -lag.z() > kAbove * size.height;
    if (lands) return foot.contact > kTouched ? SwingContact::kGround : SwingContact::kNone;
  }
  const Eigen::Vector2d v = foot.v_reference.head<2>();
  const double speed = v.norm();
  if (speed < kMinSpeed * size.speed) return SwingContact::kNone;
  if (foot.v.head<2>().dot(v) > kStopped * speed * speed) return SwingContact::kNone;
  const double behind = lag.head<2>().dot(v) / speed;
  return behind > kBehind * size.height ? SwingContact::kObstacle : SwingContact::kNone;
}

}  // namespace surefoot
