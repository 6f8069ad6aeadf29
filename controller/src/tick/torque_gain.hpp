// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/types.hpp"

namespace surefoot {

/// Compares tauEst with the commanded torques over the first 0.2 s of control, or until they agree.
///
/// The gain is that of the least-squares fit tauEst = gain * commanded over all motors, each in
/// units of its largest torque. It is 1 up to torque errors and friction, whatever the feet carry.
/// Real-time: yes.
class TorqueGain {
 public:
  /// @param tau_max [N.m] largest torque of each motor
  explicit TorqueGain(const Vector12& tau_max) : scale_(tau_max.cwiseInverse()) {}

  /// Judge a sample. @return kOk, or kWrongJointTorques at the end of the time
  Status update(const LowState& low_state, const Vector12& commanded, double dt) noexcept;
  bool done() const noexcept { return done_; }
  void reset() noexcept {
    time_ = product_ = square_ = 0.0;
    done_ = false;
  }

 private:
  // [s] Times after which a gain is right if it is in its range, or wrong. Chosen. The first one is
  // longer than the delay and lag of motors, 20 ms. The second one is longer than a transient of
  // the start, in which torques lag behind their commands, and shorter than 0.5 s, in which a b1
  // whose tauEst is wrong begins to fall.
  static constexpr double kMinTime = 0.04, kMaxTime = 0.2;
  // Range of the gain of right torques. Chosen. Wider than the 20 % by which torque constants and
  // friction are wrong; a wrong sign (-1) and kgf.m (0.1) are outside.
  static constexpr double kMinGain = 0.2, kMaxGain = 5.0;

  Vector12 scale_;  // [1/(N.m)]
  double time_ = 0.0;
  bool done_ = false;
  double product_ = 0.0, square_ = 0.0;  // sums of tauEst * commanded and of commanded^2, scaled
};

}  // namespace surefoot
