// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

namespace surefoot {

/// Return the share of the Coulomb friction that acts at joint velocity dq [rad/s], -1 .. 1.
///
/// A sign function would switch the compensating torque with the noise of a joint at rest.
inline double smooth_sign(double dq) noexcept {
  // [rad/s] Chosen far above the noise of dq at rest and below the velocities of a swing.
  constexpr double kFullSpeed = 0.5;
  return std::tanh(dq / kFullSpeed);
}

}  // namespace surefoot
