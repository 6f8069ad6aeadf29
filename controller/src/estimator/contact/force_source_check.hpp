// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/math.hpp"

namespace surefoot {

/// Sums of the loads of all feet, as shares of the weight.
struct ForceSums {
  double foot_force_est = 0.0;  ///< sum of footForceEst
  double torque = 0.0;          ///< sum of the normal forces computed from the joint torques
  /// Vertical specific force / g; the expected sum for a robot on its feet.
  double load_factor = 1.0;
  bool has_torques = true;  ///< true if torques are available
};

/// Compares the load sums of footForceEst and of the torques with each other and with the
/// accelerometer.
///
/// footForceEst works once it has shown a load on the feet that the torques confirm. Without
/// torques, a load between half and twice the weight is enough. footForceEst has failed if it shows
/// no load while the torques do. The torques are wrong if footForceEst matches the load that the
/// accelerometer implies, but the torques do not. In the air all sums are zero, so no verdict
/// changes. Real-time: yes.
class ForceSourceCheck {
 public:
  /// Process one tick.
  void update(const ForceSums& sums, double dt) noexcept;

  bool foot_force_est_works() const noexcept { return foot_force_est_works_; }
  bool torques_disagree() const noexcept { return torques_wrong_; }
  /// Return whether the torques match the accelerometer in this tick.
  bool torques_balance() const noexcept { return torques_balance_; }

 private:
  bool foot_force_est_works_ = false, torques_wrong_ = false, torques_balance_ = false;
  // [s] Time for which the sums have contradicted foot_force_est_works_.
  double est_contradiction_time_ = 0.0;
  double torque_error_time_ = 0.0;  // [s] rises while the torques are wrong, falls otherwise
};

}  // namespace surefoot
