// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/robot.hpp"

namespace surefoot {

/// The SDK's three protections: names, arguments and defaults of its safety.h, in snake case.
///
/// They are software and guarantee nothing: what keeps a robot whole is a program that sends no
/// abnormal torques. Beginners should use all of them, with level 1. Position limits are the
/// robot's own, RobotConfig::q_lower and q_upper, joint by joint: the SDK's and the URDF's
/// intersected, so nowhere wider than the vendor's and on go1 narrower (hip 0.863 instead of
/// 1.047 rad). Motors 12 .. 19 are ignored throughout.
class Safety {
 public:
  static constexpr double kWattsPerLevel = 100.0;   ///< [W] on every robot
  static constexpr double kPositionMargin = 0.087;  ///< [rad] 5 degrees

  explicit Safety(const Robot& robot);

  /// Judge the power of the motors: P = sum over i of |tauEst_i dq_i| over 100 W times level.
  ///
  /// Call it once a report, after the command is made and before it is sent, and do not send what
  /// it refuses. A counter goes up by one (to 10 at most) with each call whose P is above the
  /// limit, else down by one (to 0); above 5 it trips. So a lasting overload trips on the 6th call,
  /// one on every other call never does, and after the overload at most 4 more calls are refused:
  /// the trip is not latched. P equal to the limit is not above it. The same in the vendor's
  /// library, except that:
  ///  - the command stays as it is, as the SDK's document says; the vendor's writes mode 0x00
  ///    (brake) into motors 0 .. 11, and nothing there puts 0x0A back;
  ///  - a P that is not finite is refused in that very call and counts as above the limit; the
  ///    vendor's never trips on NaN;
  ///  - nothing is printed, and no release of ours ends the process.
  /// Level n is n x 100 W on every robot, b1 included, whose body takes 4 to 12 times the watts
  /// of a go1's in pushes of the same share of what it survives.
  /// @param cmd not read, as in the vendor's library @param state tauEst [N.m], dq [rad/s]
  /// @param level 1 .. 10, clamped; read anew in each call
  /// @return +1, or -1 when tripped. Real-time: yes.
  int power_protect(const LowCmd& cmd, const LowState& state, int level) noexcept;

  /// Judge the joint angles measured: each within [q_lower + limit, q_upper - limit].
  ///
  /// No debounce and no latch: each call speaks of its own report. NaN is outside. Where the
  /// vendor's library writes mode 0x00 into the command, this one leaves it as it is. A calf at
  /// rest fully folded is outside; a `limit` as wide as the joints' range, such as the 10 [rad] in
  /// a comment of the vendor's examples, or NaN, trips always; a negative one widens the window.
  /// @param cmd not read @param state q [rad] @param limit [rad] kept from either end
  /// @return +1, or -1 when a joint is outside: position_motor(). Real-time: yes.
  int position_protect(const LowCmd& cmd, const LowState& state,
                       double limit = kPositionMargin) noexcept;

  /// Clamp the position commands q of motors 0 .. 11 to [q_lower, q_upper], in place.
  ///
  /// |q| >= 1e9 is no position but PosStopF (2.146e9; the vendor's Python examples have 1e9) and
  /// stays: the vendor's library turns it into the joint's upper limit, to which a motor with
  /// Kp > 0 then goes. As there, mode and gains are not looked at, and NaN passes: encoding the
  /// frame refuses it. Real-time: yes.
  void position_limit(LowCmd& cmd) const noexcept;

  /// [W] P of the last power_protect(); 0 before the first.
  double power() const noexcept { return power_; }
  /// 0 .. 10; power_protect() trips above 5.
  int power_counter() const noexcept { return counter_; }
  /// SDK number of the first motor that the last position_protect() found outside, or -1.
  int position_motor() const noexcept { return motor_; }
  /// [rad] its angle; 0 where there is none.
  double position_angle() const noexcept { return angle_; }

  /// Forget all calls so far. Real-time: yes.
  void reset() noexcept;

 private:
  Vector12 q_lower_, q_upper_;
  double power_ = 0.0;
  int counter_ = 0;
  int motor_ = -1;
  double angle_ = 0.0;
};

}  // namespace surefoot
