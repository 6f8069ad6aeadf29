// SPDX-License-Identifier: BSD-3-Clause
#include "common/text.hpp"
#include "surefoot/controller.hpp"
#include "surefoot/error.hpp"
#include "tick/delay_predictor.hpp"

namespace surefoot {

void ControllerOptions::validate() const {
  // The limit of 50 is that of the gain damping_kd.
  if (!(motor_damping >= 0.0 && motor_damping <= 50.0)) {
    throw Error("option 'motor_damping' out of range: got " + to_text(motor_damping) +
                ", expected 0 .. 50 [N.m.s/rad]");
  }
  if (!(delay >= 0.0 && delay <= DelayPredictor::kMaxDelay)) {
    throw Error("option 'delay' out of range: got " + to_text(delay) + ", expected 0 .. " +
                to_text(DelayPredictor::kMaxDelay) + " [s]");
  }
  if (!(power_limit > 0.0)) {
    throw Error("option 'power_limit' out of range: got " + to_text(power_limit) +
                ", expected > 0 [W]; infinite switches the limit off");
  }
}

}  // namespace surefoot
