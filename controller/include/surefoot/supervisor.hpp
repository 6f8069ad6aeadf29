// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <memory>

#include "surefoot/arming.hpp"
#include "surefoot/fault.hpp"
#include "surefoot/stand_controller.hpp"
#include "surefoot/supervisor_enums.hpp"

namespace surefoot {

/// Options of a Supervisor: fixed at construction, unlike gains.
struct SupervisorOptions {
  /// Level of Safety::power_protect(), 1 .. 10, which trips at 100 W times the level. Rising and
  /// sitting down are planned for half of that power; while standing, stand.power_limit is at most
  /// 0.9 of that power. 0 switches the protection and this power limit off; motions are then
  /// planned for level 1.
  int power_level = 1;
  double arming_time = 1.0;           ///< [s] duration for which all checks must pass
  double temperature_warning = 60.0;  ///< [deg C] above which torque limits fall
  /// [deg C] Temperature at which torque limits are halved and the robot sits down.
  double temperature_stop = 80.0;
  double battery_low = 10.0;  ///< [%] charge below which the robot sits down
  /// [kg] Payload above which the robot sits down; infinite: no limit.
  double payload_limit = std::numeric_limits<double>::infinity();
  /// [s] Time without heartbeat() after which the robot sits down; infinite needs no operator.
  double operator_timeout = std::numeric_limits<double>::infinity();
  /// [rad] Distance that joints must keep from their limits, for arming and for fault kJointStop.
  /// Negative: the distance by which joints may exceed their limits. A fully folded calf rests on
  /// its stop, beyond the limits.
  double joint_margin = -0.15;
  StandOptions stand;           ///< options of the StandController
  Start start = Start::kLying;  ///< state of the robot at the first sample
  bool remote = true;           ///< button B on the remote stops the robot

  /// Throw surefoot::Error if an option is out of range; the message names it.
  void validate() const;
};

/// Controller that takes a robot from lying to standing and back: LowState in, LowCmd out. It
/// checks the robot before it arms, refuses requests that do not fit, detects faults, and stops on
/// request.
///
/// Rising. First the legs fold from any pose, feet beside the body and knees up. Then they move
/// over a crouch to the standing pose. All legs move alike, so the feet stay in place while the
/// body moves over the feet and up. A leg that is blocked backs out and tries again, up to eight
/// times. If the body rolls over its legs, the legs are released, at most twice. A robot that
/// already crouches or stands, with all joints within 0.35 rad of this path, rises from there
/// without folding. Before the body leaves the ground, the folded legs are weighed and the rear
/// legs press on the ground, which detects kWiring and kWrongRobot. The speed is limited so that
/// the torques that hold the robot take half of the power level. Sitting down follows the same path
/// backwards.
///
/// Torques fade between modes within 0.25 s; damping after a stop or a fault comes at once.
/// fault_table() lists the faults and the reactions to them.
///
/// Threads: update(), update_without_state(), report_link_lost(), count_samples(), set_gains(),
/// set_body_reference(), stand_controller(), command_is_fresh() and measured_power() belong to one
/// thread. All other functions may be called from any thread. No function takes a lock; faults()
/// and arming() read again if the report changed while they read it.
class Supervisor {
 public:
  /// Throws surefoot::Error if the robot does not have twelve joints on a free base, or if a gain
  /// or an option is invalid.
  explicit Supervisor(const Robot& robot);
  Supervisor(const Robot& robot, const Gains& gains, const SupervisorOptions& options = {});
  ~Supervisor();
  Supervisor(Supervisor&&) noexcept;

  /// Compute one tick. Never throws, allocates, locks or logs. Real-time: yes.
  /// @return the command to send
  const LowCmd& update(const LowState& low_state) noexcept;

  /// Compute the command of a period without a new LowState: the last command while it is at most
  /// 10 ms old, then damping. After 20 ms requests are refused until update() is called again.
  /// Nothing latches except on stop(); see report_link_lost(). Real-time: yes.
  /// @param age [s] age of the newest LowState, measured by the caller; negative or NaN: too old
  /// @return the command to send
  const LowCmd& update_without_state(double age) noexcept;
  /// Report that no LowState arrived for too long, or that the robot restarted. If the robot is
  /// armed, damping latches with fault kLink. Pending requests are dropped. Real-time: yes.
  void report_link_lost() noexcept;
  /// Report how many LowStates the link received and missed since the last call, for the arming
  /// check kLink. The link receives more samples than update() processes, and its count replaces
  /// the count of update(). The caller must then judge gaps itself and call report_link_lost().
  /// Real-time: yes.
  /// @param received number of LowStates @param missing number of LowStates; negative if some
  /// arrived late after all
  void count_samples(double received, double missing) noexcept;

  /// Request a mode: kRise from kPassive; kSit from kRise and kStand; kStand from kSit, to rise
  /// again. Any thread. Real-time: yes.
  RequestStatus request(Mode mode) noexcept;
  /// Arm the robot: allow requests, and leave latched damping for kPassive. A lost leg is used
  /// again. Any thread. Real-time: yes.
  RequestStatus arm() noexcept;
  /// Damp at once and latch, in any mode. Any thread, also repeatedly. Real-time: yes.
  void stop() noexcept;
  /// Signal that the operator is present, see SupervisorOptions::operator_timeout. Any thread.
  /// Real-time: yes.
  void heartbeat() noexcept;

  Mode mode() const noexcept;              ///< any thread
  bool armed() const noexcept;             ///< true if armed; any thread
  FaultId damping_fault() const noexcept;  ///< why damping last latched; kNone after arm()
  /// Return a consistent copy of the active and past faults of the last tick. Any thread.
  FaultReport faults() const noexcept;
  /// Return a consistent copy of the arming checks of the last tick. Any thread.
  ArmingReport arming() const noexcept;

  /// Commanded position on the path from lying (0) to standing (1); 0 before the body rises and in
  /// kPassive and kDamping.
  double rise_progress() const noexcept;
  /// [s] Planned time from folded legs to standing.
  double rise_time() const noexcept;
  /// True while torques fade from one mode to the next.
  bool fading() const noexcept;
  /// True if the last rise gave up: a leg could not fold, or the body did not follow.
  bool rise_failed() const noexcept;
  RiseStage rise_stage() const noexcept;  ///< of the present rise, or of the last one

  void set_body_reference(const BodyReference& target) noexcept;  ///< see StandController
  /// Set the gains, see StandController::set_gains(). fold_wait takes effect when the legs next
  /// begin to fold. Throws surefoot::Error and changes nothing if a gain is invalid. Real-time: no.
  void set_gains(const Gains& gains);
  const StandController& stand_controller() const noexcept;
  bool command_is_fresh() const noexcept;  ///< true: computed from the newest LowState
  /// [W] Power that the power protection last judged; 0 while the protection is off or no torques
  /// are applied.
  double measured_power() const noexcept;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace surefoot
