// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <limits>
#include <memory>
#include <string>

#include "surefoot/robot_link.hpp"
#include "surefoot/run_log.hpp"
#include "surefoot/supervisor.hpp"
#include "surefoot/udp_link.hpp"

namespace surefoot {

/// Options of a Runner.
struct RunOptions {
  double rate = 500.0;  ///< [Hz] rate of the control loop, 100 .. 1000
  /// [s] Time from first standing until finish() is called. Infinity: the run ends only with
  /// finish() or stop().
  double duration = std::numeric_limits<double>::infinity();
  /// Level of Safety::power_protect(), 1 .. 10. 0: no protection; allowed only for
  /// Start::kStanding.
  int power_level = 1;
  /// true: the sticks of the remote move the body of a standing robot and give the velocity of a
  /// walking one, START begins and ends a walk, SELECT chooses the next gait, and button B damps
  bool remote = true;
  double connect_timeout = 5.0;  ///< [s] longest wait for the first valid LowState
  /// State of the robot at the start. kStanding: the runner takes over the robot at once. kLying:
  /// the robot must pass the arming checks first, and power_level must be 1 .. 10.
  Start start = Start::kStanding;
  /// [s] Time without heartbeat() after which the robot sits down, at least 0.01. Infinity: no
  /// operator is needed.
  double operator_timeout = std::numeric_limits<double>::infinity();
  double velocity_timeout = 0.5;  ///< [s] see WalkOptions::velocity_timeout
  double log_time = 0.0;          ///< [s] length of log(), 0 .. 600; one tick takes 1.7 kB

  /// Throw surefoot::Error if an option is out of range; the message names it.
  void validate() const;
};

/// Phase of a run.
enum class RunPhase {
  kWaiting,   ///< the runner sends damping until the first valid LowState arrives
  kPassive,   ///< the motors damp until request(Mode::kRise)
  kRising,    ///< the robot rises
  kStanding,  ///< the robot stands
  kWalking,   ///< the robot walks, or stands at velocity 0, ready to walk
  kSitting,   ///< the robot sits down
  kDamping,   ///< the motors damp: latched until arm(), or while the robot is silent
  kEnded      ///< the run ends after 0.2 s of damping commands
};
/// Return the name of a phase, such as "standing". Real-time: yes.
const char* to_string(RunPhase phase) noexcept;

/// Reason of the last damping, or of the end of a run.
enum class RunReason {
  kNone,             ///< there was no damping, and the run has not ended
  kRequested,        ///< stop(), finish() or damp() was called, or the duration is over
  kNoState,          ///< no valid LowState within connect_timeout, or before the run ended
  kWrongGeneration,  ///< the robot sends frames of another generation
  kNotStanding,      ///< start kStanding, but the robot lies
  kStale,            ///< LowStates stopped arriving
  kProcessStalled,   ///< this process did not run for more than 100 ms
  kRestart,          ///< the robot restarted, so arming is no longer valid
  kController,       ///< the StandController damps, see StandController::fault()
  kPowerProtect,     ///< the power protection tripped
  kButton,           ///< button B on the remote was pressed
  kConflict,         ///< another program commands the robot, see LinkStatus::conflict
  kFault             ///< another fault, see RunSnapshot::damping_fault
};
/// Return the reason in one word, as logs write it. Real-time: yes.
const char* to_string(RunReason reason) noexcept;

/// State of a Runner, published every 50 ms and at every change of phase. Plain data.
struct RunSnapshot {
  RunPhase phase = RunPhase::kWaiting;     ///< present phase of the run
  RunReason reason = RunReason::kNone;     ///< reason of the last damping, or of the end
  Mode mode = Mode::kPassive;              ///< mode of the supervisor
  FaultId damping_fault = FaultId::kNone;  ///< fault for which damping was last latched
  FaultReport faults;                      ///< active and past faults
  ArmingReport arming;                     ///< results of the arming checks
  bool armed = false;                      ///< true if the robot is armed
  bool stood = false;                      ///< true if the robot has stood in this run
  /// True if the run was completed as requested: the robot stood, after this no fault made it damp
  /// or sit down, and the run ended on request. At the end the robot was standing (start kStanding)
  /// or had lain down (start kLying). A robot that is taken over
  /// lying does not stand.
  bool stood_to_end = false;
  bool rise_failed = false;                     ///< true if the last rise was given up
  double rise_progress = 0.0;                   ///< position from lying (0) to standing (1)
  RiseStage rise_stage = RiseStage::kHoldLegs;  ///< stage of the present or last rise
  Status controller_status = Status::kWaiting;  ///< last StandController::status()
  Status controller_fault = Status::kOk;        ///< StandController::fault()
  FrameReport last_reject;                      ///< why the last invalid datagram was rejected
  LinkCounts link;                              ///< datagram counts of the link
  double time = 0.0;                            ///< [s] since run() began
  double state_age = 0.0;                       ///< [s] age of the newest LowState
  std::uint64_t ticks = 0;                      ///< number of control ticks outside damping
  std::uint64_t usable_ticks = 0;  ///< ticks, out of `ticks`, with a command from a new LowState
  std::uint64_t ticks_without_state = 0;  ///< ticks, out of `ticks`, without a new LowState
  /// Number of ticks, out of `ticks`, in which the robot stood with a torque or the power at its
  /// limit.
  std::uint64_t saturated_ticks = 0;
  /// Number of periods without a tick, because a tick or the system took too long.
  std::uint64_t missed_periods = 0;
  /// [s] Length of the last gap in which no LowState arrived or this process did not run.
  double silence_time = 0.0;
  std::uint64_t dampings = 0;  ///< number of times that the phase kDamping began
  /// Number of times that the phase kDamping ended without arm(), because the clock of the robot
  /// had paused together with its samples.
  std::uint64_t resumed_dampings = 0;
  std::uint64_t rearms = 0;          ///< number of times that arm() ended latched damping
  std::uint64_t refused_rearms = 0;  ///< number of rearm() calls that were refused
  double measured_power = 0.0;       ///< [W] motor power that the power protection judged last
  double power_at_damping = 0.0;     ///< [W] measured_power when phase kDamping last began
  double greatest_power = 0.0;       ///< [W] largest measured_power outside damping
  double height = 0.0;         ///< [m] estimated height of the base origin above the stance feet
  double tilt = 0.0;           ///< [rad] estimated angle between base z and world z
  std::array<double, 19> q{};  ///< estimated q, Pinocchio's order, see Robot
  std::array<double, 12> joint_angles{};  ///< [rad] measured angles, SDK motor order
  /// [N] Ground force on each foot in the QP solution: FR FL RR RL, each x y z, world axes.
  std::array<double, 12> desired_forces{};
  std::array<double, 4> contact{};              ///< contact confidence 0 .. 1, FR FL RR RL
  WalkVelocity commanded_velocity;              ///< clamped; 0 after the timeout
  WalkVelocity reference_velocity;              ///< approaches commanded_velocity
  WalkLimit velocity_limit = WalkLimit::kNone;  ///< of the last velocity
  Gait gait = Gait::kAuto;                      ///< gait of the mode kWalk
  bool stopping = false;                        ///< see Supervisor::stopping()
  std::uint64_t start_presses = 0;  ///< number of times that START of the remote was pressed
  /// Answer to the request of the last press of START.
  RequestStatus start_answer = RequestStatus::kAccepted;
  double position_error = 0.0;     ///< [m] distance between the base origin and its reference
  double orientation_error = 0.0;  ///< [rad] angle between the base and its reference
  double torque_ratio = 0.0;       ///< largest |tauEst| / tau_max of the motors
  double command_power = 0.0;      ///< [W] StandController::command_power()
  // Latency of a tick: from waking up to the command sent.
  double tick_p50 = 0.0,  ///< [us] latency of a tick, median
      tick_p90 = 0.0,     ///< [us] latency of a tick, 90 % quantile
      tick_p99 = 0.0,     ///< [us] latency of a tick, 99 % quantile
      tick_p999 = 0.0,    ///< [us] latency of a tick, 99.9 % quantile
      tick_max = 0.0;     ///< [us] latency of a tick, maximum
  // Latency of waking up: from the deadline to waking up.
  double wake_p50 = 0.0,  ///< [us] latency of waking up, median
      wake_p99 = 0.0,     ///< [us] latency of waking up, 99 % quantile
      wake_p999 = 0.0,    ///< [us] latency of waking up, 99.9 % quantile
      wake_max = 0.0;     ///< [us] latency of waking up, maximum
};

/// Loop that runs a Supervisor over a RobotLink at a fixed rate.
///
/// With RunOptions::start kStanding, the runner takes over a standing robot with its first valid
/// LowState; if the robot lies, the run ends. With kLying, arm() and request() arm the robot and
/// let it rise and sit down. Deadlines are absolute; SCHED_FIFO and locked memory are used where
/// the system permits. A run begins and ends with damping commands.
///
/// Without a new LowState, the last command is repeated for at most 10 ms; then the motors damp,
/// and after 20 ms the phase is kDamping. If samples return within 100 ms and their tick shows that
/// the clock of the robot had paused as well, the run continues. Otherwise damping is latched, and
/// only arm() ends it. Damping is also latched if this process does not run for more than 100
/// ms. After a shorter pause the run continues with the newest LowState.
class Runner {
 public:
  /// Open a UdpLink to the robot; run() starts the loop. Throws surefoot::Error if an option or a
  /// gain is invalid, if a real robot is not started with Start::kLying, or if the UdpLink cannot
  /// be opened.
  Runner(const Robot& robot, const Gains& gains, const ControllerOptions& stand,
         const UdpLinkOptions& link, const RunOptions& options);
  /// Use an open link, such as a DdsLink; run() starts the loop. The caller does not use the link
  /// until run() has ended. Throws surefoot::Error if there is no link, if an option or a gain is
  /// invalid, or if the link allows a real robot and the start is not Start::kLying.
  /// @param robot model of the robot
  /// @param gains gains of the first tick
  /// @param stand options of the controller
  /// @param link open link to the robot
  /// @param options options of the loop
  Runner(const Robot& robot, const Gains& gains, const ControllerOptions& stand,
         std::shared_ptr<RobotLink> link, const RunOptions& options);
  ~Runner();
  Runner(const Runner&) = delete;
  Runner& operator=(const Runner&) = delete;

  /// Run the loop in the calling thread. The loop ends after stop() or finish(), when the duration
  /// is over, if no valid LowState arrives within connect_timeout, or if the robot uses another
  /// generation. Throws surefoot::Error if run() was called before. Real-time: the loop is; the
  /// beginning and the end are not.
  void run();

  // Call these functions from any thread, or from a signal handler. Real-time: yes.
  RequestStatus request(Mode mode) noexcept;  ///< see Supervisor::request()
  RequestStatus arm() noexcept;               ///< see Supervisor::arm()
  void rearm() noexcept;                      ///< call arm() and count refusals in refused_rearms
  /// End the run. With Start::kLying the robot first sits down. With kStanding a walking robot
  /// first stops; then this is stop().
  void finish() noexcept;
  void stop() noexcept;  ///< damp and end the run
  void damp() noexcept;  ///< latch damping; the run continues
  /// Signal that the operator is present, see RunOptions::operator_timeout. Call this function from
  /// any thread except that of run(). Real-time: yes.
  void heartbeat() noexcept;

  /// Set the gains, see StandController::set_gains(); they take effect in the next tick. Call this
  /// function from any thread. Throws surefoot::Error if a gain is invalid. Real-time: no.
  void set_gains(const Gains& gains);
  /// Set the target pose, see StandController::set_body_reference(). The target takes effect in the
  /// next tick, while the robot stands. The sticks of the remote add to the target. It is cleared
  /// when the robot stands up again. Call this function from any thread. Real-time: no.
  void set_body_reference(const BodyReference& target);

  /// Set the velocity of a walking robot, see Supervisor::set_velocity(). It takes effect in the
  /// next tick, and is 0 after RunOptions::velocity_timeout. The sticks of the remote add to it.
  /// Call this function from any thread. Real-time: no.
  void set_velocity(const WalkVelocity& velocity);
  /// Set the gait, see Supervisor::set_gait(). Call this function from any thread. Real-time: no.
  void set_gait(Gait gait);

  /// Return the log of the last RunOptions::log_time seconds, a reference that is valid as long as
  /// this object exists. The log begins with the first LowState. It stops 5 s (at most log_time /
  /// 2) after the robot last moved or stood. So the ticks before damping are not overwritten while
  /// damping lasts. Throws surefoot::Error while run() is running. Real-time: no.
  const RunLog& log() const;
  /// Return a copy of the last published snapshot. Call this function from any thread except that
  /// of run(). Real-time: no.
  RunSnapshot snapshot() const;
  /// Describe the scheduling and memory locking that run() got; "not running" before run().
  /// Real-time: no.
  std::string real_time() const;
  int local_port() const noexcept;  ///< local UDP port; 0: the link is no UdpLink

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace surefoot
