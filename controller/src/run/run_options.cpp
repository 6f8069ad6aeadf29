// SPDX-License-Identifier: BSD-3-Clause
#include <limits>

#include "common/text.hpp"
#include "surefoot/error.hpp"
#include "surefoot/runner.hpp"

namespace surefoot {

void RunOptions::validate() const {
  const auto check = [](const char* name, double got, double lower, double upper,
                        const char* unit) {
    if (got >= lower && got <= upper) return;
    throw Error(std::string("option '") + name + "' out of range: got " + to_text(got) +
                ", expected " + to_text(lower) + " .. " + to_text(upper) + unit);
  };
  // Limits of the rate, derived: the controller integrates at most 10 ms in one step (TickClock),
  // so at least 100 Hz; LowState::tick counts milliseconds, so at most 1000 Hz. Limit of log_time,
  // chosen: it bounds the memory of the log.
  check("rate", rate, 100.0, 1000.0, " [Hz]");
  check("power_level", power_level, 0, 10, " (0 switches the protection off)");
  if (start == Start::kLying) {
    check("power_level", power_level, 1, 10, " with start 'lying'");
  }
  check("connect_timeout", connect_timeout, 0.0, 1e6, " [s]");
  check("log_time", log_time, 0.0, 600.0, " [s]");
  check("operator_timeout", operator_timeout, 0.01, std::numeric_limits<double>::infinity(),
        " [s]");
  check("velocity_timeout", velocity_timeout, 0.01, 60.0, " [s]");
  if (!(duration > 0.0)) {
    throw Error("option 'duration' out of range: got " + to_text(duration) + ", expected > 0 [s]");
  }
}

const char* to_string(RunPhase phase) noexcept {
  switch (phase) {
    case RunPhase::kWaiting:
      return "waiting";
    case RunPhase::kPassive:
      return "passive";
    case RunPhase::kRising:
      return "rising";
    case RunPhase::kStanding:
      return "standing";
    case RunPhase::kWalking:
      return "walking";
    case RunPhase::kSitting:
      return "sitting";
    case RunPhase::kDamping:
      return "damping";
    case RunPhase::kEnded:
      return "ended";
  }
  return "unknown";
}

const char* to_string(RunReason reason) noexcept {
  switch (reason) {
    case RunReason::kNone:
      return "none";
    case RunReason::kRequested:
      return "asked";
    case RunReason::kNoState:
      return "no_state";
    case RunReason::kWrongGeneration:
      return "wrong_generation";
    case RunReason::kNotStanding:
      return "not_standing";
    case RunReason::kStale:
      return "stale";
    case RunReason::kProcessStalled:
      return "away";
    case RunReason::kRestart:
      return "restart";
    case RunReason::kController:
      return "controller";
    case RunReason::kPowerProtect:
      return "power_protect";
    case RunReason::kButton:
      return "button";
    case RunReason::kConflict:
      return "conflict";
    case RunReason::kFault:
      return "fault";
  }
  return "unknown";
}

}  // namespace surefoot
