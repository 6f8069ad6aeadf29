// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "surefoot/math.hpp"

namespace surefoot {

/// Return the angle between a body's z axis and the world's vertical [rad]. Real-time: yes.
/// @param up the world's vertical in base axes, unit length
inline double tilt_angle(const Vector3& up) noexcept {
  return std::acos(std::clamp(up.z(), -1.0, 1.0));
}

/// Return the angle between two vectors of any length [rad]. Real-time: yes.
inline double angle_between(const Vector3& a, const Vector3& b) noexcept {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// Return the roll angle of the body [rad], asin(up.y). Positive: the right side is down.
/// Real-time: yes.
/// @param up the world's vertical in base axes, unit length
inline double roll_angle(const Vector3& up) noexcept {
  return std::asin(std::clamp(up.y(), -1.0, 1.0));
}

}  // namespace surefoot
