// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "gait/gait_size.hpp"

namespace surefoot {

/// Reference and measurement of a swing foot, world frame.
struct SwingFoot {
  Vector3 p_reference, v_reference;  ///< [m], [m/s]
  Vector3 p, v;                      ///< measured [m], [m/s]
  double height;                     ///< measured, above the ground plane [m]
  double contact;                    ///< contact confidence, 0 .. 1
};

/// What stops a swing foot.
enum class SwingContact {
  kNone,     ///< nothing
  kGround,   ///< the foot was stopped while its reference moved down: it has landed
  kObstacle  ///< the foot was stopped in the horizontal direction: it hit a face
};

/// Judge what stops a swing foot. Real-time: yes.
///
/// The direction of the contact force does not tell whether a foot has landed or hit the face of a
/// step: in both cases the force has a normal part and a friction part. So the direction in which
/// the foot stays behind its reference decides.
SwingContact judge_swing_contact(const SwingFoot& foot, const GaitSize& size) noexcept;

}  // namespace surefoot
