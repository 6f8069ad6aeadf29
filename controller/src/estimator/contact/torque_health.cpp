// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/contact/torque_health.hpp"

namespace surefoot {

namespace {
constexpr double kHeld = 0.1;  // [s]
}

// No robot with twelve torques of exactly zero stands: the field is not filled.
void TorqueHealth::update(const Vector12& tau_est, bool moving, double dt) noexcept {
  const bool held = tau_est == last_;
  held_ = held ? held_ + (moving ? dt : 0.0) : 0.0;
  last_ = tau_est;
  if (tau_est.isZero(0.0)) {
    verdict_ = Verdict::kZero;
  } else {
    verdict_ = held_ > kHeld ? Verdict::kConstant : Verdict::kGood;
  }
}

}  // namespace surefoot
