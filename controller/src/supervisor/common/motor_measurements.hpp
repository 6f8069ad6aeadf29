// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/low_level.hpp"
#include "surefoot/math.hpp"

namespace surefoot {

/// Return the joint torques that the motors report (tauEst), SDK motor order [N.m]. Real-time: yes.
inline Vector12 measured_torques(const LowState& state) noexcept {
  Vector12 tau;
  for (int i = 0; i < kMotors; ++i) tau[i] = state.motorState[i].tauEst;
  return tau;
}

/// Return the measured joint velocities (dq), SDK motor order [rad/s]. Real-time: yes.
inline Vector12 measured_velocities(const LowState& state) noexcept {
  Vector12 dq;
  for (int i = 0; i < kMotors; ++i) dq[i] = state.motorState[i].dq;
  return dq;
}

}  // namespace surefoot
