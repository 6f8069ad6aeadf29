// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "surefoot/math.hpp"

namespace surefoot {

/// Angle between a body's own vertical and the world's [rad]. Real-time: yes.
/// @param up the world's vertical, in base axes, of unit length
inline double tilt_angle(const Vector3& up) noexcept {
  return std::acos(std::clamp(up.z(), -1.0, 1.0));
}

/// Angle between two directions of any length [rad]. Real-time: yes.
inline double angle_between(const Vector3& a, const Vector3& b) noexcept {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// The part of tilt_angle() by which the body has rolled, positive to its right [rad]. Real-time:
/// yes.
inline double roll_angle(const Vector3& up) noexcept {
  return std::asin(std::clamp(up.y(), -1.0, 1.0));
}

}  // namespace surefoot
