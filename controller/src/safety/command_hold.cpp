// SPDX-License-Identifier: BSD-3-Clause
#include "safety/command_hold.hpp"

namespace surefoot {

namespace {
// [s] Numerical: tolerance for the rounding of summed periods, which are whole milliseconds.
constexpr double kRounding = 1e-9;
}  // namespace

const LowCmd& CommandHold::accept(const LowCmd& command) noexcept {
  command_ = command;
  has_command_ = true;
  age_ = 0.0;
  return command_;
}

const LowCmd& CommandHold::repeat_or_damp(double elapsed, double damping_kd) noexcept {
  age_ += elapsed;
  if (!has_command_ || latched_ || age_ > kHoldTime + kRounding) {
    latched_ = latched_ || has_command_;
    command_ = damping_low_cmd(damping_kd);
  }
  return command_;
}

const LowCmd& CommandHold::latch(double damping_kd) noexcept {
  latched_ = true;
  return damp(damping_kd);
}

const LowCmd& CommandHold::damp(double damping_kd) noexcept {
  command_ = damping_low_cmd(damping_kd);
  return command_;
}

const LowCmd& CommandHold::substitute(const LowCmd& command, double elapsed,
                                      double damping_kd) noexcept {
  if (in_control()) command_ = command;
  return repeat_or_damp(elapsed, damping_kd);
}

}  // namespace surefoot
