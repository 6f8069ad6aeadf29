// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/math.hpp"

namespace surefoot {

/// What the sums over all feet say, as shares of the weight.
struct ForceSums {
  double est = 0.0;          ///< of footForceEst
  double torque = 0.0;       ///< of the normal forces by torques
  double load_factor = 1.0;  ///< vertical specific force / g: what feet that carry would bear
  bool torques = true;       ///< are there torques at all?
};

/// Judges footForceEst and the torques as a whole, by each other and by the accelerometer.
///
/// footForceEst lives once it carries the robot, as the torques or, without them, the weight itself
/// bear out; a field of zeros says nothing. Torques that miss what the accelerometer feels while
/// footForceEst bears it are wrong. In the air both are silent, and nothing is learnt.
/// Real-time: yes.
class ForceSourceCheck {
 public:
  void update(const ForceSums& sums, double dt) noexcept;

  bool foot_force_est_alive() const noexcept { return foot_force_est_alive_; }
  bool torques_disagree() const noexcept { return torques_wrong_; }
  /// Do the torques carry what the accelerometer feels, at this instant?
  bool torques_balance() const noexcept { return torques_balance_; }

 private:
  bool foot_force_est_alive_ = false, torques_wrong_ = false, torques_balance_ = false;
  double est_contradiction_time_ =
      0.0;                          // [s] for which what is held of the field has been contradicted
  double torque_error_time_ = 0.0;  // [s] leaky
};

}  // namespace surefoot
