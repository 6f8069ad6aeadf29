// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/math.hpp"

namespace surefoot {

/// Sums of the loads over all feet, as shares of the weight.
struct ForceSums {
  double est = 0.0;          ///< of footForceEst
  double torque = 0.0;       ///< of the normal forces from joint torques
  double load_factor = 1.0;  ///< vertical specific force / g: the load expected in contact
  bool torques = true;       ///< true if torques are available
};

/// Checks the sums of footForceEst and of the torques against each other and the accelerometer.
///
/// footForceEst counts as working once it has shown a load on the feet that the torques confirm;
/// without torques, a plausible share of the weight suffices. Torques are wrong if they miss the
/// load that the accelerometer implies while footForceEst matches it. In the air all sums are zero
/// and no verdict changes. Real-time: yes.
class ForceSourceCheck {
 public:
  /// Process one tick.
  void update(const ForceSums& sums, double dt) noexcept;

  bool foot_force_est_works() const noexcept { return foot_force_est_alive_; }
  bool torques_disagree() const noexcept { return torques_wrong_; }
  /// Return whether the torques match the accelerometer in this tick.
  bool torques_balance() const noexcept { return torques_balance_; }

 private:
  bool foot_force_est_alive_ = false, torques_wrong_ = false, torques_balance_ = false;
  double est_contradiction_time_ = 0.0;  // [s] sums against foot_force_est_alive_
  double torque_error_time_ = 0.0;       // [s] leaky
};

}  // namespace surefoot
