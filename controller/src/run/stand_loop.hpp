// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>

#include "run/mailbox.hpp"
#include "run/silence.hpp"
#include "surefoot/stand_runner.hpp"

namespace surefoot {

/// What a StandRunner does in a tick: which commands leave, and why. It knows no clock of its own.
///
/// What the robot does is the Supervisor's to decide; here it is decided whether the robot is
/// heard, and when to end.
class StandLoop {
 public:
  /// Throws surefoot::Error.
  StandLoop(const Robot& robot, const Gains& gains, const StandOptions& stand,
            const UdpLinkOptions& link, const RunOptions& options);

  /// Receive, think, send. Real-time: yes.
  /// @param time [s] since the loop began @param elapsed [s] since the tick before
  void tick(double time, double elapsed) noexcept;
  bool ended() const noexcept { return now_.phase == RunPhase::kEnded; }
  /// Nothing but damping. Real-time: yes.
  void send_damping() noexcept { link_.send(damping_); }

  // From any thread, and from a signal handler:
  RequestStatus request(Mode mode) noexcept { return supervisor_.request(mode); }
  RequestStatus arm() noexcept { return supervisor_.arm(); }
  void rearm() noexcept;
  void finish() noexcept { finish_.store(true); }
  void stop() noexcept { stop_.store(true); }
  void damp() noexcept;
  void heartbeat() noexcept { supervisor_.heartbeat(); }

  // From any thread:
  void set_gains(const Gains& gains);  ///< throws surefoot::Error
  void set_body_reference(const BodyReference& target) { reference_letter_.put(target); }

  /// How it is, but for what only the clock knows. Real-time: yes.
  const RunSnapshot& describe() noexcept;
  /// Has its phase changed since this was asked last? Real-time: yes.
  bool has_news() noexcept;
  int local_port() const noexcept { return link_.local_port(); }
  const RunLog& log() const noexcept { return log_; }

 private:
  void wait_for_robot() noexcept;
  void supervise(bool newer, double elapsed) noexcept;
  void send(const LowCmd& command, bool heard) noexcept;
  void log(const LowCmd& command, bool heard) noexcept;
  void count_reports() noexcept;
  const LowCmd& control(const LowState& state) noexcept;
  const LowCmd& bridge(double age, double elapsed) noexcept;
  void forgive_or_lose() noexcept;
  void lose(RunReason why) noexcept;
  void watch() noexcept;
  void judge_order(Mode before) noexcept;
  RunPhase phase() const noexcept;
  RunReason why_damped() const noexcept;
  void obey_letters() noexcept;
  void obey_sticks() noexcept;
  void sit_down_and_end() noexcept;
  void end(RunReason why) noexcept;

  RunOptions options_;
  Supervisor supervisor_;
  UdpLink link_;
  Vector12 tau_max_;  // [N.m]
  LowCmd damping_;    // before the robot is known, and at the end
  Gains gains_;
  BodyReference asked_;  // besides what the remote asks for
  Mailbox<Gains> gains_letter_;
  Mailbox<BodyReference> reference_letter_;
  Silence silence_;
  bool silent_ = false;                // the robot is; it may yet be forgiven
  RunReason lost_ = RunReason::kNone;  // why, when the supervisor damps for a lost link
  RunSnapshot now_;
  RunLog log_;
  double driven_ = -1.0;                   // [s] when motors were last driven; negative: never
  double counts_from_ = -1.0;              // [s] when the duration began; negative: it has not
  std::uint64_t restarts_ = 0;             // of the robot, that were taken in
  std::uint64_t valid_ = 0, missing_ = 0;  // reports that the supervisor was told of
  bool news_ = false;
  bool in_order_ = false;  // it stands, or lay down because it was asked to
  std::atomic<bool> stop_{false}, damp_{false}, finish_{false};
  std::atomic<std::uint64_t> refused_{0};
};

}  // namespace surefoot
