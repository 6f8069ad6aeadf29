// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/robot.hpp"

namespace surefoot {

/// The three protections of the SDK, with the names (in snake case), arguments and defaults of its
/// safety.h.
///
/// They run in software and guarantee nothing: a robot is safe only if its controller sends no
/// abnormal torques. Beginners should use all three, with level 1. The position limits are
/// RobotConfig::q_lower and q_upper: the intersection of SDK and URDF limits, joint by joint. No
/// limit is wider than the vendor's; on go1 some are narrower (hip 0.863 rad instead of 1.047 rad).
/// Motors 12 .. 19 are ignored.
class Safety {
 public:
  static constexpr double kWattsPerLevel = 100.0;   ///< [W] power limit per level
  static constexpr double kPositionMargin = 0.087;  ///< [rad] the SDK's default, 5 degrees

  /// Copy the joint limits of `robot`. Real-time: no.
  explicit Safety(const Robot& robot);

  /// Check the power of the motors: P = sum over motors of |tauEst dq|, against 100 W times level.
  ///
  /// Call it once per sample, after computing the command and before sending it, and do not send
  /// the command if the result is -1. Each call whose P is above the limit increases a counter by
  /// one (up to 10). All other calls decrease the counter by one (down to 0). The protection trips
  /// above 5. So a lasting overload trips on the 6th call, an overload in every other call never
  /// trips, and after an overload at most 4 more calls return -1: the trip is not latched. P equal
  /// to the limit does not count as above it. The rule is that of the vendor's library, with these
  /// differences:
  ///  - The command stays unchanged, as in the SDK's document. The vendor's library writes mode
  ///    0x00 (brake) into motors 0 .. 11 and does not restore 0x0A.
  ///  - If P is not finite, the same call returns -1, and P counts as above the limit. The vendor's
  ///    library never trips on NaN.
  ///  - Nothing is printed, and the process never ends.
  ///
  /// A level means the same power on every robot. When both are pushed with the same fraction of
  /// their push limits, b1 takes 4 to 12 times the power of go1.
  /// @param cmd not read, as in the vendor's library
  /// @param state tauEst [N.m] and dq [rad/s] of motors 0 .. 11 are read
  /// @param level 1 .. 10, clamped; may change from call to call
  /// @return +1, or -1 if tripped. Real-time: yes.
  int power_protect(const LowCmd& cmd, const LowState& state, int level) noexcept;

  /// Check the measured joint angles: each must be within [q_lower + limit, q_upper - limit].
  ///
  /// There is no debouncing and no latch: each call judges its own sample alone. NaN counts as
  /// outside the range. The command stays unchanged; the vendor's library writes mode 0x00 into the
  /// command. Note: a fully folded calf at rest is outside the range, so a lying robot trips. The
  /// check always trips if `limit` is NaN or leaves no range, for example the 10 rad in a comment
  /// of the vendor's examples. A negative `limit` widens the range.
  /// @param cmd not read
  /// @param state q [rad] of motors 0 .. 11 is read
  /// @param limit [rad] distance kept from both ends of the range
  /// @return +1, or -1 if a joint is outside, see position_motor(). Real-time: yes.
  int position_protect(const LowCmd& cmd, const LowState& state,
                       double limit = kPositionMargin) noexcept;

  /// Clamp the position commands q [rad] of motors 0 .. 11 to [q_lower, q_upper], in place.
  ///
  /// A command |q| >= 1e9 counts as PosStopF and is not changed. (PosStopF is 2.146e9; the vendor's
  /// Python examples use 1e9.) The vendor's library clamps such a command instead, so a motor with
  /// Kp > 0 moves to its upper limit. As in the vendor's library, mode and gains are ignored and
  /// NaN is not changed; encode_low_cmd() refuses NaN. Real-time: yes.
  void position_limit(LowCmd& cmd) const noexcept;

  /// Return P [W] of the last power_protect(), or 0 before the first call. Real-time: yes.
  double power() const noexcept { return power_; }
  /// Return the counter of power_protect(), 0 .. 10; the protection trips above 5. Real-time: yes.
  int power_counter() const noexcept { return power_counter_; }
  /// Return the SDK number of the first motor outside its range in the last position_protect(), or
  /// -1 if there was none. Real-time: yes.
  int position_motor() const noexcept { return position_motor_; }
  /// Return the angle [rad] of position_motor(), or 0 if there is none. Real-time: yes.
  double position_angle() const noexcept { return position_angle_; }

  /// Reset the counter and all results of earlier calls. Real-time: yes.
  void reset() noexcept;

 private:
  Vector12 q_lower_, q_upper_;
  double power_ = 0.0;
  int power_counter_ = 0;
  int position_motor_ = -1;
  double position_angle_ = 0.0;
};

}  // namespace surefoot
