// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/fault.hpp"

namespace surefoot {

/// Keeps the FaultReport: which faults are active, how often each fault has begun, and at which
/// motor. Real-time: yes.
class FaultLog {
 public:
  FaultLog() { report_.motor.fill(-1); }

  /// Set whether a fault is present. The fault is counted when it begins.
  /// @param motor SDK number if the fault concerns one motor, otherwise -1
  void set(FaultId id, bool present, int motor = -1) noexcept {
    const int k = static_cast<int>(id);
    if (present && !report_.active[k]) {
      ++report_.count[k];
      report_.last = id;
    }
    if (present) report_.motor[k] = motor;
    report_.active[k] = present;
  }

  const FaultReport& report() const noexcept { return report_; }

 private:
  FaultReport report_;
};

}  // namespace surefoot
