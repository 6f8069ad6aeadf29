// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <memory>

#include "surefoot/arming.hpp"
#include "surefoot/fault.hpp"
#include "surefoot/mode.hpp"
#include "surefoot/stand_controller.hpp"

namespace surefoot {

/// What is set once.
struct SupervisorOptions {
  /// 1 .. 10, of Safety::power_protect(), which trips at 100 W times it, whatever pushes the robot.
  /// Rising and sitting are planned below it; while standing, stand.power_limit is 0.9 of it or
  /// less. 0 switches the protection off, and with it that limit; plans then keep below level 1.
  int power_level = 1;
  double arming_time = 1.0;           ///< [s] that all checks must have passed
  double temperature_warning = 60.0;  ///< [deg C] torque limits fall from here on ...
  double temperature_stop = 80.0;     ///< [deg C] ... to half, where the robot sits down
  double battery_low = 10.0;          ///< [%] of charge, below which it sits down
  /// [kg] that it may bear besides itself before it sits down
  double payload_limit = std::numeric_limits<double>::infinity();
  /// [s] without heartbeat() before it sits down; infinite: nobody need be there
  double operator_timeout = std::numeric_limits<double>::infinity();
  /// [rad] kept from the limits for arming; negative: so far beyond. A calf at rest fully folded
  /// lies on its stop, outside the limits that motions keep.
  double joint_margin = -0.15;
  StandOptions stand;
  Start start = Start::kLying;
  bool remote = true;  ///< B on the remote stops

  /// Throw surefoot::Error naming what is out of range.
  void validate() const;
};

/// Takes a robot from lying to standing and back, behind arming, refusals and a stop: LowState in,
/// LowCmd out.
///
/// Rising folds the legs from wherever they are, feet beside the body and knees up, then goes over
/// a crouch to the standing pose, all legs alike, so that feet stay where they are while the body
/// comes over them and up. A leg that catches on something backs out and tries again, up to eight
/// times. A body that rolls over its legs is let go of, twice. A robot that crouches or stands
/// already, joints within 0.35 rad of that way, does not fold but goes on from there. Before the
/// body leaves the ground the folded legs are weighed and the rear ones press: faults kWiring and
/// kWrongRobot. The pace is what half of the power level allows by the torques that hold the robot.
/// Sitting is the same way backwards. Torques fade from mode to mode in 0.25 s; only damping for a
/// stop or a fault is at once. What is wrong and what is done about it: fault_table().
///
/// update(), bridge(), lose(), count_samples(), set_gains(), set_body_reference(),
/// stand_controller(), command_is_fresh() and measured_power() belong to one thread. All others may
/// be called from any. None takes a lock; faults() and arming() read again what was written over
/// while they read it.
class Supervisor {
 public:
  /// Throws surefoot::Error when the robot (twelve joints on a free base), a gain or an option is
  /// invalid.
  explicit Supervisor(const Robot& robot);
  Supervisor(const Robot& robot, const Gains& gains, const SupervisorOptions& options = {});
  ~Supervisor();
  Supervisor(Supervisor&&) noexcept;

  /// Compute one tick; never throws, allocates, locks or logs. Real-time: yes.
  const LowCmd& update(const LowState& low_state) noexcept;

  /// Go on for a period that brought no LowState: the last command while it is no older than 10 ms,
  /// then damping; after 20 ms requests are refused until update() is called again. Nothing latches
  /// but what stop() asks for: see lose(). Real-time: yes.
  /// @param age [s] of the newest LowState, which the caller measures; negative or NaN: too old
  const LowCmd& update_without_state(double age) noexcept;
  /// The robot was not heard for too long, or what is heard now is another: what was armed damps
  /// and latches, and what waits is forgotten. Real-time: yes.
  void report_link_lost() noexcept;
  /// Say what the link has counted since the last call, for the arming check kLink: it hears more
  /// reports than are handed on to update(), whose own count this replaces. Gaps between those are
  /// then the caller's to judge: lose(). Real-time: yes.
  void count_samples(double received, double missing) noexcept;

  /// Ask for a mode: kRise from passive; kSit from rise and stand; kStand while sitting down, to
  /// come up again. Any thread. Real-time: yes.
  RequestStatus request(Mode mode) noexcept;
  /// Allow requests, and leave latched damping for passive; a leg that was lost counts again. Any
  /// thread. Real-time: yes.
  RequestStatus arm() noexcept;
  /// Damp at once and latch, whatever the mode. Any thread, any number of times. Real-time: yes.
  void stop() noexcept;
  /// The operator is there: see the option operator_timeout. Any thread. Real-time: yes.
  void heartbeat() noexcept;

  Mode mode() const noexcept;
  bool armed() const noexcept;
  FaultId damping_fault() const noexcept;  ///< why the damping latched last
  /// Which faults there are and have been, a consistent copy of the last tick's. Any thread.
  FaultReport faults() const noexcept;
  /// Every check with its verdict, a consistent copy of the last tick's. Any thread.
  ArmingReport arming() const noexcept;

  /// How far up the robot is on the way from lying (0) to standing (1), as commanded.
  double rise_progress() const noexcept;
  /// [s] that the plan takes from lying legs folded to standing.
  double rise_time() const noexcept;
  /// Are torques on their way from mode to mode?
  bool fading() const noexcept;
  /// Did the last rise give up because a leg could not fold or the body could not follow?
  bool rise_failed() const noexcept;
  RiseStage rise_stage() const noexcept;  ///< of the last rise, or of this

  void set_body_reference(const BodyReference& target) noexcept;  ///< in force while standing
  /// As StandController's; fold_wait is in force when legs begin to fold. Throws surefoot::Error.
  void set_gains(const Gains& gains);
  const StandController& stand_controller() const noexcept;
  bool command_is_fresh() const noexcept;  ///< was the last command made from its own LowState?
  /// [W] that the power protection judged last; 0 while it has nothing to judge.
  double measured_power() const noexcept;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace surefoot
