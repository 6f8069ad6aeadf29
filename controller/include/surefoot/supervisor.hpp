// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <memory>

#include "surefoot/arming.hpp"
#include "surefoot/fault.hpp"
#include "surefoot/supervisor_enums.hpp"
#include "surefoot/walk_controller.hpp"

namespace surefoot {

/// Options of a Supervisor: fixed at construction, unlike gains.
struct SupervisorOptions {
  /// Level of Safety::power_protect(), 1 .. 10, which trips at 100 W times the level.
  ///
  /// Rises and descents are planned for half of this power. While it stands or walks, the power
  /// limit is 0.9 of this power or stand.power_limit, whichever is smaller. With level 0 the
  /// protection is off, stand.power_limit is used as it is, and rises and descents are planned for
  /// level 1.
  int power_level = 1;
  double arming_time = 1.0;           ///< [s] time for which all arming checks must have passed
  double temperature_warning = 60.0;  ///< [deg C] motor temperature that reduces torque limits
  /// [deg C] Motor temperature from which torque limits are halved and the robot sits down.
  double temperature_stop = 80.0;
  double battery_low = 10.0;  ///< [%] battery charge below which the robot sits down
  /// [kg] Payload above which the robot sits down; infinity: no limit.
  double payload_limit = std::numeric_limits<double>::infinity();
  /// [s] Time without heartbeat() after which the robot sits down; infinity: no operator is needed.
  double operator_timeout = std::numeric_limits<double>::infinity();
  /// [rad] Distance that joints must keep from their limits, for arming and for the fault
  /// kJointStop. Negative: distance by which joints may exceed their limits. A fully folded calf
  /// rests on its stop, beyond the limits.
  double joint_margin = -0.15;
  ControllerOptions stand;        ///< options of the WalkController's tick
  double velocity_timeout = 0.5;  ///< [s] see WalkOptions::velocity_timeout
  Start start = Start::kLying;    ///< state of the robot at the first sample
  bool remote = true;             ///< true: button B on the remote stops the robot

  /// Throw surefoot::Error if an option is out of range; the message names it.
  void validate() const;
};

/// Controller that takes a robot from lying to standing and back, and lets it walk: LowState in,
/// LowCmd out.
///
/// The supervisor checks the robot before arming, refuses requests that the present mode does not
/// allow, detects faults, and stops on request.
///
/// Rising. First the legs fold from any pose, feet beside the body and knees up. Then the legs move
/// through a crouch to the standing pose. All legs follow the same joint path. So the feet stay in
/// place, and the body moves above the feet and then up. A leg that is blocked backs out and tries
/// again, up to eight times. If the body rolls over its legs, the legs follow their joints without
/// stiffness for 1 s and then fold again; this happens at most twice. A robot that already crouches
/// or stands, with all joints within 0.35 rad of this path, rises from there without folding.
/// Before the body leaves the ground, the folded legs are weighed and the rear legs press on the
/// ground. These two checks detect the faults kWiring and kWrongRobot. The speed is limited: the
/// holding torques may take at most half of the power of SupervisorOptions::power_level. Sitting
/// down follows the same path backwards.
///
/// Walking. In the mode kWalk the robot follows set_velocity(), and stands at velocity 0. It
/// returns to kStand on request(kStand), when the velocity has expired, or for a fault that stops
/// walking. Before it stands or sits down, it stops on four feet. A robot that shall sit down and
/// has not stopped within 1.5 s sits down all the same. stop() and faults that damp act at once, in
/// any phase of the gait.
///
/// Torques fade between modes within 0.25 s; damping after a stop or a fault starts at once.
/// fault_table() lists the faults and the reactions to them.
///
/// Threads: update(), update_without_state(), report_link_lost(), report_conflict(),
/// count_samples(), set_gains(), set_body_reference(), set_velocity(), set_gait(), gait(),
/// controller(), command_is_fresh() and measured_power() belong to one thread. All other functions
/// may be called from any thread. No function takes a lock; faults() and arming() read again if the
/// report changed while they read it.
class Supervisor {
 public:
  /// Create a supervisor with RobotConfig::gains and default options. Throws surefoot::Error if the
  /// robot does not have twelve joints on a free base, or if a gain or an option is invalid.
  explicit Supervisor(const Robot& robot);
  /// The same with other gains than RobotConfig::gains.
  Supervisor(const Robot& robot, const Gains& gains, const SupervisorOptions& options = {});
  ~Supervisor();
  /// Take over the content of another Supervisor, which may only be destroyed afterwards.
  Supervisor(Supervisor&&) noexcept;

  /// Compute one tick. Never throws, allocates, locks or logs. Real-time: yes.
  /// @param low_state newest sample
  /// @return the command to send
  const LowCmd& update(const LowState& low_state) noexcept;

  /// Compute the command of a period without a new LowState: the last command while it is at most
  /// 10 ms old, and damping after that. After 20 ms requests are refused until update() is called
  /// again. This function latches damping only after stop(). To latch damping after a long gap,
  /// call report_link_lost(), as Runner does. Real-time: yes.
  /// @param age [s] age of the newest LowState, measured by the caller; negative and NaN count as
  /// too old
  /// @return the command to send
  const LowCmd& update_without_state(double age) noexcept;
  /// Report that no LowState arrived for too long, or that the robot restarted. If the robot is
  /// armed, damping is latched with the fault kLink. Pending requests are dropped. Real-time: yes.
  void report_link_lost() noexcept;
  /// Report whether another program commands the robot, or a second robot sends LowStates, see
  /// LinkStatus::conflict. While this is so, the arming check kConflict fails. From the next
  /// update() on, arming and rising are refused, and a standing robot is not taken over. To damp a
  /// robot that is armed, call report_link_lost(), as Runner does. Real-time: yes.
  void report_conflict(bool present) noexcept;
  /// Report how many LowStates the link received and missed since the last call.
  ///
  /// The arming check kLink uses these counts. They replace the counts of update(), because the
  /// link receives more samples than update() processes. The caller must then judge gaps itself and
  /// call report_link_lost(). Real-time: yes.
  /// @param received number of LowStates that arrived
  /// @param missing number of LowStates that did not arrive; negative if LowStates counted as
  /// missing arrived later
  void count_samples(double received, double missing) noexcept;

  /// Request a mode. Allowed requests: kRise from kPassive; kSit from kRise, kStand or kWalk;
  /// kStand from kSit, to stand up again, and from kWalk, to stop; kWalk from kStand. A robot that
  /// walks stops before it changes its mode. Any thread. Real-time: yes.
  RequestStatus request(Mode mode) noexcept;
  /// Arm the robot: allow requests, and change from latched damping to kPassive. A lost leg is used
  /// again. Any thread. Real-time: yes.
  RequestStatus arm() noexcept;
  /// Damp at once and latch, in any mode. Any thread, also repeatedly. Real-time: yes.
  void stop() noexcept;
  /// Signal that the operator is present, see SupervisorOptions::operator_timeout. Any thread.
  /// Real-time: yes.
  void heartbeat() noexcept;

  Mode mode() const noexcept;   ///< present mode; any thread
  bool armed() const noexcept;  ///< true if the robot is armed; any thread
  /// Fault for which damping was last latched; kNone after arm(). Any thread.
  FaultId damping_fault() const noexcept;
  /// Return a consistent copy of the active and past faults of the last tick. Any thread.
  FaultReport faults() const noexcept;
  /// Return a consistent copy of the arming checks of the last tick. Any thread.
  ArmingReport arming() const noexcept;

  /// Reference position on the path from lying (0) to standing (1); 0 before the body rises, and in
  /// kPassive and kDamping.
  double rise_progress() const noexcept;
  /// [s] Planned time from folded legs to standing.
  double rise_time() const noexcept;
  /// True while torques fade from one mode to the next.
  bool fading() const noexcept;
  /// True if the last rise was given up: a leg could not fold, or the body did not follow.
  bool rise_failed() const noexcept;
  RiseStage rise_stage() const noexcept;  ///< stage of the present rise, or of the last one

  /// Set the target pose of the body while standing, see StandController::set_body_reference().
  /// Real-time: yes.
  void set_body_reference(const BodyReference& target) noexcept;
  /// Set the velocity, see WalkController::set_velocity(). Ignored unless the mode is kWalk, and
  /// while the robot stops. Call it more often than SupervisorOptions::velocity_timeout. Real-time:
  /// yes.
  void set_velocity(const WalkVelocity& velocity) noexcept;
  /// Set the gait of kWalk; initially Gait::kAuto. Real-time: yes.
  void set_gait(Gait gait) noexcept;
  Gait gait() const noexcept;  ///< gait of kWalk; of the thread of update()
  /// True while a robot that walked or stepped stops, before it stands or sits down.
  bool stopping() const noexcept;
  /// Set the gains, see StandController::set_gains(). The gain fold_wait takes effect at the next
  /// folding. Throws surefoot::Error and changes nothing if a gain is invalid. Real-time: no.
  void set_gains(const Gains& gains);
  /// Return the controller of a robot that stands or walks, for reading. Real-time: yes.
  const WalkController& controller() const noexcept;
  /// True if the last command was computed from the newest LowState.
  bool command_is_fresh() const noexcept;
  /// [W] Motor power in the last sample that the power protection judged; 0 while the protection is
  /// off or no torques are applied.
  double measured_power() const noexcept;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace surefoot
