// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/estimator_report.hpp"

namespace surefoot {

/// Are there joint torques in the reports at all, and do they live? Real-time: yes.
class TorqueCheck {
 public:
  /// @param others_changed have other fields of the report changed since the last?
  void update(const Vector12& tau_est, bool others_changed, double dt) noexcept;
  SensorVerdict verdict() const noexcept { return verdict_; }
  void reset() noexcept { *this = TorqueCheck(); }

 private:
  Vector12 last_tau_ = Vector12::Constant(NAN);
  double unchanged_time_ = 0.0;  // [s]
  SensorVerdict verdict_ = SensorVerdict::kGood;
};

}  // namespace surefoot
