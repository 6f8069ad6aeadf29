// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <memory>

#include "run/mailbox.hpp"
#include "run/remote_reference.hpp"
#include "run/silence_detector.hpp"
#include "surefoot/runner.hpp"

namespace surefoot {

/// One tick of a Runner's loop: receives samples, chooses the command to send, and records why
/// the robot damps or the run ends. The class reads no clock, because the caller passes the time.
///
/// The Supervisor decides what the robot does. The loop decides whether the link to the robot
/// works, and when the run ends.
class RunLoop {
 public:
  /// Throw surefoot::Error under the conditions of Runner, except that the link is open.
  /// @param link open link to the robot, not null
  RunLoop(const Robot& robot, const Gains& gains, const ControllerOptions& stand,
          std::shared_ptr<RobotLink> link, const RunOptions& options);

  /// Receive samples, compute the command and send it. Real-time: yes.
  /// @param time time since the loop began [s]
  /// @param elapsed time since the last tick [s]
  void tick(double time, double elapsed) noexcept;
  bool ended() const noexcept { return snapshot_.phase == RunPhase::kEnded; }
  /// Send damping. Real-time: yes.
  void send_damping() noexcept { link_->send(damping_); }

  // From any thread, also from a signal handler:
  RequestStatus request(Mode mode) noexcept { return supervisor_.request(mode); }
  RequestStatus arm() noexcept { return supervisor_.arm(); }
  void rearm() noexcept;
  void finish() noexcept { finish_requested_.store(true); }
  void stop() noexcept { stop_requested_.store(true); }
  void damp() noexcept;
  void heartbeat() noexcept { supervisor_.heartbeat(); }

  // From any thread:
  void set_gains(const Gains& gains);  ///< throws surefoot::Error
  void set_body_reference(const BodyReference& target) { reference_mailbox_.put(target); }
  void set_velocity(const WalkVelocity& velocity) { velocity_mailbox_.put(velocity); }
  void set_gait(Gait gait) { gait_mailbox_.put(gait); }

  /// Return the state of the loop. SnapshotPublisher adds missed periods and latencies. Real-time:
  /// yes.
  const RunSnapshot& snapshot() noexcept;
  /// Return whether the phase has changed since the last call. Real-time: yes.
  bool take_phase_change() noexcept;
  const RunLog& log() const noexcept { return log_; }

 private:
  void wait_for_robot() noexcept;
  void supervise(bool has_new_state, double elapsed) noexcept;
  void send(const LowCmd& command, bool has_new_state) noexcept;
  void log(const LowCmd& command, bool has_new_state) noexcept;
  void count_samples() noexcept;
  const LowCmd& control(const LowState& state) noexcept;
  const LowCmd& update_without_state(double age, double elapsed) noexcept;
  bool lies() const noexcept;
  void resume_or_report_lost() noexcept;
  void report_link_lost(RunReason why) noexcept;
  void update_phase() noexcept;
  void update_stood_as_requested(Mode previous_mode) noexcept;
  RunPhase phase() const noexcept;
  RunReason damping_reason() const noexcept;
  void apply_requests() noexcept;
  void apply_remote(const WirelessRemote& remote) noexcept;
  void handle_start_button(bool pressed) noexcept;
  void handle_select_button(bool pressed) noexcept;
  void apply_velocity(const WalkVelocity& sticks) noexcept;
  void sit_down_and_end() noexcept;
  void end(RunReason why) noexcept;

  RunOptions options_;
  Supervisor supervisor_;
  std::shared_ptr<RobotLink> link_;
  Vector12 tau_max_;        // [N.m]
  double standing_height_;  // [m] of the base above its contact points, in the standing pose
  LowCmd damping_;          // sent before the first LowState, and at the end
  Gains gains_;
  // Pose requested by set_body_reference(), without the offsets of the remote's sticks.
  BodyReference requested_pose_;
  Mailbox<Gains> gains_mailbox_;
  Mailbox<BodyReference> reference_mailbox_;
  Mailbox<WalkVelocity> velocity_mailbox_;
  Mailbox<Gait> gait_mailbox_;
  WalkVelocity requested_velocity_;  // by set_velocity(), without the remote's sticks
  // [s] Time of the last set_velocity(); -infinity: none yet.
  double velocity_time_ = -std::numeric_limits<double>::infinity();
  StickSpeeds stick_speeds_;
  // START and SELECT of the remote in the last sample.
  bool start_pressed_ = false, select_pressed_ = false;
  bool walk_by_remote_ = false;  // the present walk was begun with START
  WalkVelocity velocity_;        // passed to the supervisor in this tick
  bool has_velocity_ = false;
  Gait gait_ = Gait::kAuto;
  SilenceDetector silence_detector_;
  // true: the robot is silent, and control may resume.
  bool robot_silent_ = false;
  RunReason link_loss_reason_ = RunReason::kNone;  // reason that is reported for FaultId::kLink
  RunSnapshot snapshot_;
  RunLog log_;
  // [s] Time of the last tick in a mode other than passive and damping; negative: none yet.
  double last_driven_time_ = -1.0;
  // [s] Time when RunOptions::duration began; negative: not yet.
  double duration_start_ = -1.0;
  std::uint64_t counted_restarts_ = 0;  // number of restarts of the robot that have been handled
  // Numbers of samples that have been reported to the supervisor.
  std::uint64_t counted_valid_ = 0, counted_lost_ = 0;
  bool phase_changed_ = false;
  // True if the robot stands, or has sat down from there without a fault.
  bool stood_as_requested_ = false;
  std::atomic<bool> stop_requested_{false}, damp_requested_{false}, finish_requested_{false};
  std::atomic<std::uint64_t> refused_rearms_{0};
};

}  // namespace surefoot
