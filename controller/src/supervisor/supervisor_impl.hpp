// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "safety/command_hold.hpp"
#include "safety/tick_clock.hpp"
#include "supervisor/arming/arming_checks.hpp"
#include "supervisor/common/seqlock.hpp"
#include "supervisor/faults/clock_monitor.hpp"
#include "supervisor/faults/debounce.hpp"
#include "supervisor/faults/encoder_monitor.hpp"
#include "supervisor/faults/estimator_faults.hpp"
#include "supervisor/faults/fault_log.hpp"
#include "supervisor/faults/imu_monitor.hpp"
#include "supervisor/faults/joint_monitor.hpp"
#include "supervisor/faults/motor_faults.hpp"
#include "supervisor/faults/repeated_sample.hpp"
#include "supervisor/getting_up/checks/leg_weight_check.hpp"
#include "supervisor/getting_up/checks/light_leg_check.hpp"
#include "supervisor/getting_up/checks/rear_press_check.hpp"
#include "supervisor/getting_up/folding/leg_folding.hpp"
#include "supervisor/getting_up/joint_impedance.hpp"
#include "supervisor/getting_up/rise_motion.hpp"
#include "supervisor/modes/requests.hpp"
#include "supervisor/modes/torque_fade.hpp"
#include "supervisor/modes/torque_rate_limiter.hpp"
#include "surefoot/safety.hpp"
#include "surefoot/supervisor.hpp"

namespace surefoot {

/// State machine of the Supervisor: its modes, and the steps of a tick.
///
/// Modes: passive -> rise -> stand -> sit -> passive; stand -> walk -> stand or sit; any mode ->
/// damping. A rise has the stages of RiseStage: hold legs, fold, weigh, press, up. Only arm()
/// leaves the mode damping. In the modes passive and damping, the motors only damp; rise and sit
/// use JointImpedance; stand and walk use the WalkController. TorqueFade blends the torques when
/// the mode changes, except for a change to damping.
///
/// A tick has five steps:
///   1. read_sample() checks the LowState; an unusable LowState is a sample fault.
///   2. judge() runs the fault detectors on a usable sample; react() makes the robot sit or damp.
///   3. handle_request() handles the request that another thread has posted.
///   4. step_motion() moves the joint reference of rise or sit; step_walk() ends walks and stops.
///   5. command() computes the LowCmd. Without a usable sample, CommandHold repeats the last LowCmd
///      for 10 ms; then damping is latched.
///
/// Threads: `requests`, Seqlock members and atomics are shared with other threads. `plan` and
/// `options` are constant. All other members belong to the thread of the tick.
struct Supervisor::Impl {
  Impl(const Robot& robot, const Gains& gains, const SupervisorOptions& options);

  const LowCmd& tick(const LowState& state) noexcept;
  const LowCmd& update_without_state(double age) noexcept;
  void report_link_lost() noexcept;
  void set_gains(const Gains& gains);
  void set_velocity(const WalkVelocity& velocity) noexcept;
  void set_gait(Gait next) noexcept;

  /// WalkController of a robot that may be unable to walk, see RequestStatus::kCannotWalk.
  struct UncheckedWalkController : WalkController {
    UncheckedWalkController(const Robot& robot, const Gains& gains, const WalkOptions& options)
        : WalkController(Unchecked(), robot, gains, options) {}
  };

  Robot robot;
  SupervisorOptions options;
  RisePlan plan;
  ArmingChecks arming;
  LegFolding folding;
  LegWeightCheck weight_check;
  RearPressCheck press_check;
  RiseMotion motion;
  JointImpedance impedance;
  UncheckedWalkController controller;
  Safety safety;
  Requests requests;
  Seqlock<ArmingReport> arming_report;
  Seqlock<FaultReport> faults;
  std::atomic<FaultId> latched_fault{FaultId::kNone};  // fault that latched damping, or kNone
  std::atomic<unsigned> heartbeats{0};
  std::atomic<bool> rise_abandoned{false};  // true if the last rise was abandoned
  std::atomic<RiseStage> published_stage{RiseStage::kHoldLegs};
  std::atomic<double> published_progress{0.0};  // path parameter of the rise, 0 .. 1
  Gait gait = Gait::kAuto;                      // of the mode kWalk
  bool fresh = false;  // true if the last command was computed from the last sample

 private:
  /// [s] A longer step of LowState::tick must be confirmed by a second sample, because a single
  /// tick may be wrong. Chosen. Longer than kHoldTime: after such a step no command is repeated any
  /// more. Longer than 13 ms, the step of samples at 100 Hz with 3 ms of jitter. Shorter than 17
  /// ms, the gap that must latch damping in tests/cpp/test_supervisor_link.cpp.
  static constexpr double kLongestStep = 0.015;

  bool read_sample(const LowState& state, double step, double dt) noexcept;
  FaultId find_sample_fault(const LowState& state, double step) noexcept;
  void judge(const LowState& state, double dt) noexcept;
  void judge_tilt(const LowState& state) noexcept;
  void judge_legs() noexcept;
  void judge_loss_battery_and_operator(const LowState& state, double dt) noexcept;
  void react() noexcept;
  void handle_request(int request) noexcept;
  void take_over() noexcept;
  void enter_mode(Mode mode) noexcept;
  void start_sitting() noexcept;
  void start_walk() noexcept;
  void stop_stepping(Mode next) noexcept;
  void step_walk(double dt) noexcept;
  void start_rise() noexcept;
  void step_motion(const LowState& state, double dt) noexcept;
  void rise(const LowState& state, double dt) noexcept;
  void hold_legs(const LowState& state, double dt) noexcept;
  void fold(double dt) noexcept;
  void weigh(const LowState& state, double dt) noexcept;
  void press(const LowState& state, double dt) noexcept;
  void raise_body(const LowState& state, double dt) noexcept;
  void abort_rise(FaultId why, int motor) noexcept;
  void sit(double dt) noexcept;
  void enter_passive() noexcept;
  void invalidate_state() noexcept;
  void latch(FaultId why) noexcept;
  MotorDemand demand_of(TorqueSource source, const LowState& state) noexcept;
  const LowCmd& command(const LowState& state, double dt) noexcept;
  void publish() noexcept;
  bool active() const noexcept {
    return context.mode != Mode::kPassive && context.mode != Mode::kDamping;
  }
  /// Return whether the motors get torques, and not damping alone.
  bool applies_torque() const noexcept { return active() || fade.active(); }
  bool is_raising_body() const noexcept { return stage == RiseStage::kUp; }
  /// Return whether the robot stands or walks, so that the estimator runs.
  bool is_on_feet() const noexcept {
    return (context.mode == Mode::kStand || context.mode == Mode::kWalk) && !fade.active();
  }
  /// Return whether the feet step: in a walk, or to keep the balance.
  bool is_stepping() const noexcept { return is_on_feet() && controller.reference().stepping; }

  RequestContext context;
  Mode after_stop = Mode::kStand;  // mode that follows when the robot has stopped
  double stop_time = 0.0;          // [s] since the robot began to stop
  TickClock clock{kLongestStep};
  CommandHold command_hold;
  TorqueFade fade;
  JointReference reference;  // input of `impedance`
  RiseStage stage = RiseStage::kHoldLegs;
  LightLegCheck light_leg_check;
  FaultLog log;
  MotorFaults motors;
  EstimatorFaults estimator_faults;
  TorqueRateLimiter rate_limiter;
  RepeatedSample repeated;
  std::uint32_t last_tick = 0;
  bool state_received = false;  // true if a usable sample has arrived since the link was lost
  double bad_time = 0.0;        // [s] duration of the present series of unusable samples
  // [s] Time since the last sample that passed check_low_state().
  double unchecked_time = 0.0;
  ImuMonitor imu;
  JointMonitor joints;
  EncoderMonitor encoders;
  ClockMonitor clock_monitor;
  Debounce battery, rate_limited, unsolved;
  bool limited_by_step = false;           // torques are rate-limited since feet stepped
  FaultId sample_fault = FaultId::kNone;  // fault that made the last sample unusable, or kNone
  unsigned last_heartbeats = 0;           // value of `heartbeats` in the last tick
  double operator_silence = 0.0;          // [s] time since the last heartbeat
  double damping_kd;
};

}  // namespace surefoot
