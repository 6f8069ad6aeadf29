// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <limits>
#include <memory>
#include <string>

#include "surefoot/run_log.hpp"
#include "surefoot/supervisor.hpp"
#include "surefoot/udp_link.hpp"

namespace surefoot {

/// Options of a StandRunner.
struct RunOptions {
  double rate = 500.0;  ///< [Hz] rate of the control loop, 100 .. 1000
  double duration = std::numeric_limits<double>::infinity();  ///< [s] from first standing until
                                                              ///< finish() is called
  int power_level = 1;             ///< level of Safety::power_protect(), 1 .. 10; 0 switches it off
  bool remote = true;              ///< the sticks of the remote move the body, and button B damps
  double connect_timeout = 5.0;    ///< [s] longest wait for the first valid LowState
  Start start = Start::kStanding;  ///< kLying: arming checks first; needs power_level 1 .. 10
  /// [s] Time without heartbeat() after which the robot sits down; infinite needs no operator.
  double operator_timeout = std::numeric_limits<double>::infinity();
  double log_time = 0.0;  ///< [s] of ticks that log() keeps, 1.7 kB each; 0 .. 600

  /// Throw surefoot::Error if an option is out of range; the message names it.
  void validate() const;
};

/// Phase of a run.
enum class RunPhase {
  kWaiting,   ///< for the first valid LowState; sends damping
  kPassive,   ///< the motors brake until request(Mode::kRise)
  kRising,    ///< the robot rises
  kStanding,  ///< the StandController is in control
  kSitting,   ///< the robot sits down
  kDamping,   ///< latched: the motors brake until arm()
  kEnded      ///< run() ends, after 0.2 s of damping commands
};
/// Return the name of a phase, such as "standing". Real-time: yes.
const char* to_string(RunPhase phase) noexcept;

/// Reason of the last damping, or of the end of a run.
enum class RunReason {
  kNone,
  kRequested,        ///< stop(), finish() or damp() was called, or the duration is over
  kNoState,          ///< no valid LowState arrived in time, or before the end
  kWrongGeneration,  ///< the robot sends frames of another generation
  kNotStanding,      ///< start kStanding, but the robot lies
  kStale,            ///< LowStates stopped arriving
  kProcessStalled,   ///< this process stalled for more than 100 ms
  kRestart,          ///< the robot restarted after it was armed
  kController,       ///< the StandController damps: see StandController::fault()
  kPowerProtect,     ///< the power protection tripped
  kButton,           ///< button B on the remote
  kFault             ///< another fault: RunSnapshot::damping_fault
};
/// /// Return the reason in one word, as logs write it. Real-time: yes.
const char* to_string(RunReason reason) noexcept;

/// State of a StandRunner, published every 50 ms and at every change of phase. Plain data.
struct RunSnapshot {
  RunPhase phase = RunPhase::kWaiting;
  RunReason reason = RunReason::kNone;     ///< of the last damping, or of the end
  Mode mode = Mode::kPassive;              ///< of the supervisor
  FaultId damping_fault = FaultId::kNone;  ///< why the supervisor last latched damping
  FaultReport faults;                      ///< active and past faults
  ArmingReport arming;                     ///< arming checks
  bool armed = false;                      ///< true if the robot is armed
  bool stood = false;                      ///< true if the robot has stood in this run
  /// True if the robot stood, no fault damped it or made it sit down afterwards, and the run ended
  /// on request: with start kLying after the robot lay down, with kStanding while it stood. A robot
  /// that is taken over lying does not stand.
  bool stood_to_end = false;
  bool rise_failed = false;                     ///< true if the last rise gave up
  double rise_progress = 0.0;                   ///< from lying (0) to standing (1)
  RiseStage rise_stage = RiseStage::kHoldLegs;  ///< of the present rise, or of the last one
  Status controller_status = Status::kWaiting;  ///< StandController::status() of its last tick
  Status controller_fault = Status::kOk;        ///< StandController::fault()
  FrameReport last_reject;                      ///< why the last invalid datagram was rejected
  LinkCounts link;                              ///< datagram counts of the link
  double time = 0.0;                            ///< [s] since run() began
  double state_age = 0.0;                       ///< [s] age of the newest LowState
  std::uint64_t ticks = 0;                      ///< control ticks outside damping
  std::uint64_t usable_ticks = 0;               ///< of these, ticks with a fresh command
  std::uint64_t ticks_without_state = 0;        ///< of these, ticks without a new LowState
  std::uint64_t saturated_ticks = 0;  ///< of these, standing with torques or power at a limit
  std::uint64_t missed_periods =
      0;                       ///< periods left out because a tick or the system took too long
  double silence_time = 0.0;   ///< [s] silence of the robot or of this process, when last detected
  std::uint64_t dampings = 0;  ///< times that damping was latched
  std::uint64_t resumed_dampings = 0;  ///< of these, ended because the robot's clock had paused too
  std::uint64_t rearms = 0;            ///< times that arming left latched damping
  std::uint64_t refused_rearms = 0;  ///< rearm() calls that were refused: no LowState, or not ready
  double measured_power = 0.0;       ///< [W] last power judged by the power protection
  double power_at_damping = 0.0;     ///< [W] the same, when damping was last latched
  double greatest_power = 0.0;       ///< [W] largest measured_power outside damping
  double height = 0.0;               ///< [m] estimated height of the base origin, world frame
  double tilt = 0.0;                 ///< [rad] estimated angle between base z and world z
  std::array<double, 19> q{};        ///< estimated q, Pinocchio's order
  std::array<double, 12> joint_angles{};    ///< [rad] as reported, SDK motor order
  std::array<double, 12> desired_forces{};  ///< [N] ground on feet, FR FL RR RL x y z, world axes
  std::array<double, 4> contact{};          ///< contact confidence 0 .. 1, FR FL RR RL
  double position_error = 0.0;     ///< [m] distance of the base from its reference position
  double orientation_error = 0.0;  ///< [rad] angle of the base from its reference orientation
  double torque_ratio = 0.0;       ///< largest |tauEst| / tau_max of the motors
  double command_power = 0.0;      ///< [W] StandController::command_power()
  // [us] Quantiles and maximum of two latencies: tick, from waking up to the command sent; wake,
  // from the deadline to waking up.
  double tick_p50 = 0.0, tick_p90 = 0.0, tick_p99 = 0.0, tick_p999 = 0.0, tick_max = 0.0;
  double wake_p50 = 0.0, wake_p99 = 0.0, wake_p999 = 0.0, wake_max = 0.0;
};

/// Loop that runs a Supervisor over a UdpLink at a fixed rate.
///
/// With RunOptions::start kStanding, the runner takes over a standing robot with its first valid
/// LowState; if the robot lies, the run ends. With kLying, arm() and request() arm the robot and
/// let it rise and sit down. Deadlines are absolute; SCHED_FIFO and locked memory are used where
/// the system permits. A run begins and ends with damping commands.
///
/// Without a new LowState, the last command is repeated for at most 10 ms; then the motors damp,
/// and after 20 ms damping is latched. Only arm() leaves latched damping, with one exception: a
/// LowState within 100 ms whose tick shows that the robot's clock paused too. If the system keeps
/// this process from running for more than 100 ms, damping is latched too; after a shorter stall
/// the run continues with the newest LowState.
class StandRunner {
 public:
  /// Throws surefoot::Error if an option or a gain is invalid, if a real robot is not started
  /// lying, or if the UdpLink cannot be opened.
  StandRunner(const Robot& robot, const Gains& gains, const StandOptions& stand,
              const UdpLinkOptions& link, const RunOptions& options);
  ~StandRunner();
  StandRunner(const StandRunner&) = delete;
  StandRunner& operator=(const StandRunner&) = delete;

  /// Run the loop in the calling thread until stop() or finish(), the end of the duration, no valid
  /// LowState within connect_timeout, or a robot of another generation. Throws surefoot::Error if
  /// it was called before. Real-time: the loop is, the beginning and the end are not.
  void run();

  // From any thread, and from a signal handler:
  RequestStatus request(Mode mode) noexcept;  ///< see Supervisor::request()
  RequestStatus arm() noexcept;               ///< see Supervisor::arm()
  void rearm() noexcept;   ///< arm(); RunSnapshot::refused_rearms counts refusals
  void finish() noexcept;  ///< start kLying: sit down, damp and end the run; else stop()
  void stop() noexcept;    ///< damp and end the run
  void damp() noexcept;    ///< damp, latched; the run goes on
  /// Signal that the operator is present, see RunOptions::operator_timeout. Call it from another
  /// thread than run(). Real-time: yes.
  void heartbeat() noexcept;

  // From any thread; they take effect in the next tick. Real-time: no.
  /// Set the gains, see StandController::set_gains(). Throws surefoot::Error if a gain is invalid.
  void set_gains(const Gains& gains);
  /// Set the target pose, see StandController::set_body_reference(). The sticks of the remote add
  /// to it. It applies while the robot stands, and is cleared when the robot stands up again.
  void set_body_reference(const BodyReference& target);

  /// Return the ticks of the last RunOptions::log_time. The reference is valid as long as this
  /// object exists. The log begins with the first LowState. It stops 5 s after the robot was last
  /// in motion or standing (half of log_time if that is less), so that a long damping does not
  /// overwrite the ticks before it. Throws surefoot::Error while run() is running.
  const RunLog& log() const;
  /// Return a copy of the snapshot published last. Call it from any thread except the thread of
  /// run(). Real-time: no.
  RunSnapshot snapshot() const;
  /// Describe the scheduling and memory locking that run() obtained, in words; empty before run().
  std::string real_time() const;
  int local_port() const noexcept;  ///< local UDP port

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace surefoot
