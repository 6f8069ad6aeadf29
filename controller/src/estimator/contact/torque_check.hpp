// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/estimator_report.hpp"

namespace surefoot {

/// Checks whether the samples contain joint torques, and whether the torques change.
/// Real-time: yes.
class TorqueCheck {
 public:
  /// Process one sample.
  /// @param others_changed true if other fields differ from the last sample
  void update(const Vector12& tau_est, bool others_changed, double dt) noexcept;
  SensorVerdict verdict() const noexcept { return verdict_; }
  void reset() noexcept { *this = TorqueCheck(); }

 private:
  Vector12 last_tau_ = Vector12::Constant(NAN);
  double unchanged_time_ = 0.0;  // [s] time with constant torques while other fields changed
  SensorVerdict verdict_ = SensorVerdict::kGood;
};

}  // namespace surefoot
