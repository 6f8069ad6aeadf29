// SPDX-License-Identifier: BSD-3-Clause
#include "safety/command_keeper.hpp"

namespace surefoot {

namespace {
constexpr double kRounding = 1e-9;  // [s] ticks are whole milliseconds, their sums nearly so
}

const LowCmd& CommandKeeper::accept(const LowCmd& command) noexcept {
  command_ = command;
  has_command_ = true;
  age_ = 0.0;
  return command_;
}

const LowCmd& CommandKeeper::refuse(double elapsed, double damping_kd) noexcept {
  age_ += elapsed;
  if (!has_command_ || latched_ || age_ > kHoldTime + kRounding) {
    latched_ = latched_ || has_command_;
    command_ = damping_low_cmd(damping_kd);
  }
  return command_;
}

const LowCmd& CommandKeeper::damp(double damping_kd) noexcept {
  command_ = damping_low_cmd(damping_kd);
  return command_;
}

const LowCmd& CommandKeeper::bridge(const LowCmd& command, double elapsed,
                                    double damping_kd) noexcept {
  if (controls()) command_ = command;
  return refuse(elapsed, damping_kd);
}

}  // namespace surefoot
