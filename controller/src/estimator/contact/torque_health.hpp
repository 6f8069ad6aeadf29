// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/estimator_report.hpp"

namespace surefoot {

/// Are there joint torques in the reports at all, and do they live? Real-time: yes.
class TorqueHealth {
 public:
  /// @param moving have other fields of the report changed since the last?
  void update(const Vector12& tau_est, bool moving, double dt) noexcept;
  Verdict verdict() const noexcept { return verdict_; }
  void reset() noexcept { *this = TorqueHealth(); }

 private:
  Vector12 last_ = Vector12::Constant(NAN);
  double held_ = 0.0;  // [s]
  Verdict verdict_ = Verdict::kGood;
};

}  // namespace surefoot
