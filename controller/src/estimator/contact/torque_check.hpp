// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/estimator_report.hpp"

namespace surefoot {

/// Checks whether the samples contain joint torques, and whether the torques change.
/// Real-time: yes.
class TorqueCheck {
 public:
  /// Process one sample.
  /// @param others_changed true if other fields of the sample differ from the last sample
  void update(const Vector12& tau_est, bool others_changed, double dt) noexcept;
  SensorVerdict verdict() const noexcept { return verdict_; }
  void reset() noexcept { *this = TorqueCheck(); }

 private:
  Vector12 last_tau_ = Vector12::Constant(NAN);
  // [s] Time for which the torques have been constant while other fields changed.
  double unchanged_time_ = 0.0;
  SensorVerdict verdict_ = SensorVerdict::kGood;
};

}  // namespace surefoot
