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

struct RunOptions {
  double rate = 500.0;  ///< [Hz] of the control loop
  double duration =
      std::numeric_limits<double>::infinity();  ///< [s] of standing, from the first; then finish()
  int power_level = 1;             ///< of Safety::power_protect(), 1 .. 10; 0 switches it off
  bool remote = true;              ///< sticks move the body, a button damps
  double connect_timeout = 5.0;    ///< [s] to wait for the first valid LowState
  Start start = Start::kStanding;  ///< kLying: behind arming checks; power_level 1 .. 10
  /// [s] without heartbeat() before the robot sits down; infinite: nobody need be there
  double operator_timeout = std::numeric_limits<double>::infinity();
  double log_time = 0.0;  ///< [s] of ticks that log() keeps, 1.7 kB each; 0 .. 600

  /// Throw surefoot::Error naming what is out of range.
  void validate() const;
};

/// What the loop is doing.
enum class RunPhase {
  kWaiting,   ///< for the first valid LowState; damping frames leave
  kPassive,   ///< the motors brake until request(Mode::kRise)
  kRising,    ///< on its way up
  kStanding,  ///< the controller's commands leave
  kSitting,   ///< on its way down
  kDamping,   ///< latched: the motors brake until arm()
  kEnded
};
const char* to_string(RunPhase phase) noexcept;

/// Why it damps, or ended.
enum class RunReason {
  kNone,
  kRequested,        ///< stop(), or the duration is over
  kNoState,          ///< no valid LowState came in time, or before the end
  kWrongGeneration,  ///< the robot speaks another generation
  kStale,            ///< LowStates stopped coming
  kProcessStalled,   ///< this program stood still: the robot went on without it
  kRestart,          ///< the robot began anew: it is not the one that was armed
  kController,       ///< the controller damps: see StandController::fault()
  kPowerProtect,
  kButton,
  kFault  ///< what else the supervisor damps for: RunSnapshot::damping_fault
};
const char* to_string(RunReason reason) noexcept;

/// A look at the loop from outside.
struct RunSnapshot {
  RunPhase phase = RunPhase::kWaiting;
  RunReason reason = RunReason::kNone;     ///< of the last damping, or of the end
  Mode mode = Mode::kPassive;              ///< of the supervisor
  FaultId damping_fault = FaultId::kNone;  ///< the supervisor's, of the last damping
  FaultReport faults;                      ///< which there are and have been
  ArmingReport arming;                     ///< what passes and what does not, and for how long
  bool armed = false;
  bool stood = false;  ///< has it stood at all?
  /// Has it stood, and lain down because it was asked to (kStanding: stood on), until the end?
  bool stood_to_end = false;
  bool rise_failed = false;                     ///< has the last rise given up?
  double rise_progress = 0.0;                   ///< from lying (0) to standing (1)
  RiseStage rise_stage = RiseStage::kHoldLegs;  ///< of the last rise
  Status controller_status = Status::kWaiting;  ///< of the controller's last tick
  Status controller_fault = Status::kOk;        ///< of the controller
  FrameReport last_reject;                      ///< the last datagram that was not taken
  LinkCounts link;
  double time = 0.0;                      ///< [s] since run() began
  double state_age = 0.0;                 ///< [s] of the newest LowState
  std::uint64_t ticks = 0;                ///< of control
  std::uint64_t usable_ticks = 0;         ///< of those, with a fresh command
  std::uint64_t ticks_without_state = 0;  ///< of those, without a new LowState
  std::uint64_t saturated_ticks = 0;
  std::uint64_t missed_periods =
      0;                       ///< periods left out because a tick or the system took too long
  double silence_time = 0.0;   ///< [s] that the robot, or this program, was silent: stale, away
  std::uint64_t dampings = 0;  ///< times that it latched
  std::uint64_t resumed_dampings =
      0;  ///< of those, left because the robot's clock had stood still as well
  std::uint64_t rearms = 0;
  std::uint64_t refused_rearms = 0;  ///< by rearm(): no LowState came, or checks failed
  double measured_power = 0.0;       ///< [W] that the protection judged last
  double power_at_damping = 0.0;     ///< [W] the same, when it damped last
  double greatest_power = 0.0;
  double height = 0.0;                      ///< [m] estimated
  double tilt = 0.0;                        ///< [rad] estimated
  std::array<double, 19> q{};               ///< Pinocchio's, estimated
  std::array<double, 12> joint_angles{};    ///< [rad] as reported, SDK motor order
  std::array<double, 12> desired_forces{};  ///< [N] asked of FR FL RR RL, each x y z, world axes
  std::array<double, 4> contact{};          ///< belief that each foot bears
  double position_error = 0.0;              ///< [m] of the base from its reference
  double orientation_error = 0.0;           ///< [rad] the same of its attitude
  double torque_ratio = 0.0;                ///< greatest share of its limit in tauEst
  double command_power = 0.0;               ///< [W] see StandController::command_power()
  // [us] from waking to the command sent, and from the deadline to waking:
  double tick_p50 = 0.0, tick_p90 = 0.0, tick_p99 = 0.0, tick_p999 = 0.0, tick_max = 0.0;
  double wake_p50 = 0.0, wake_p99 = 0.0, wake_p999 = 0.0, wake_max = 0.0;
};

/// Runs a Supervisor over a UdpLink at a fixed rate.
///
/// With RunOptions::start kStanding a robot that stands is taken over with its first good LowState;
/// with kLying it is armed, risen and sat down by arm() and request().
/// Deadlines are absolute; SCHED_FIFO and locked memory are used where permitted. It begins and
/// ends with damping frames. Without a new LowState the last command is repeated for at most 10 ms,
/// then the motors damp, and after 20 ms for good: a latched damping is left by arm() alone, or
/// within 100 ms when LowState::tick says that the robot's clock stood still with it. A
/// program that the system kept from running for 100 ms damps for good as well; after less it goes
/// on with the report that is new.
class StandRunner {
 public:
  /// Throws surefoot::Error: an invalid option or gain, a real robot that is not started lying, or
  /// what UdpLink throws.
  StandRunner(const Robot& robot, const Gains& gains, const StandOptions& stand,
              const UdpLinkOptions& link, const RunOptions& options);
  ~StandRunner();
  StandRunner(const StandRunner&) = delete;
  StandRunner& operator=(const StandRunner&) = delete;

  /// Run until stop(), the duration, or a robot that cannot be controlled; in the calling thread.
  /// Throws surefoot::Error if it was called before.
  void run();

  // From any thread, and from a signal handler:
  RequestStatus request(Mode mode) noexcept;  ///< as Supervisor's
  RequestStatus arm() noexcept;               ///< as Supervisor's
  void rearm() noexcept;   ///< arm() whose refusals are counted: RunSnapshot::refused_rearms
  void finish() noexcept;  ///< with start kLying: sit down, then damp, and end; else stop()
  void stop() noexcept;    ///< damp, and end
  void damp() noexcept;    ///< damp, and stay
  /// The operator's end is alive: RunOptions::operator_timeout. Not from run()'s own thread.
  /// Real-time: yes.
  void heartbeat() noexcept;

  // From any thread; obeyed with the next tick:
  void set_gains(const Gains& gains);  ///< as StandController's; throws surefoot::Error
  /// As StandController's, and the remote's sticks add to it. In force while the robot stands;
  /// forgotten when it stands anew.
  void set_body_reference(const BodyReference& target);

  /// The last RunOptions::log_time of ticks, from the robot's first report on, and until 5 s (half
  /// of log_time, where that is less) after it was last driven: what brakes for longer has
  /// happened. As long-lived as this. Throws surefoot::Error while run() runs.
  const RunLog& log() const;
  /// From any other thread; what was last published.
  RunSnapshot snapshot() const;
  std::string real_time()
      const;  ///< what scheduling and memory it got, in words; after run() began
  int local_port() const noexcept;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace surefoot
