// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/fault.hpp"

namespace surefoot {

/// What has lasted, as opposed to what flickers. Real-time: yes.
class Lasting {
 public:
  /// Has `now` been true for `least` [s] without a break?
  bool update(bool now, double dt, double least) noexcept {
    time_ = now ? time_ + dt : 0.0;
    return now && time_ >= least - kRounding;
  }

 private:
  static constexpr double kRounding = 1e-9;  // [s]
  double time_ = 0.0;                        // [s]
};

/// Keeps the FaultReport: what begins, what ends. Real-time: yes.
class FaultLog {
 public:
  FaultLog() { report_.motor.fill(-1); }

  /// Say of a fault whether it is there. @param motor SDK number, where it is one motor's
  void set(FaultId id, bool there, int motor = -1) noexcept {
    const int k = static_cast<int>(id);
    if (there && !report_.active[k]) {
      ++report_.count[k];
      report_.last = id;
    }
    if (there) report_.motor[k] = motor;
    report_.active[k] = there;
  }

  const FaultReport& report() const noexcept { return report_; }

 private:
  FaultReport report_;
};

}  // namespace surefoot
