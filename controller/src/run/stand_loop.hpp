// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>

#include "run/mailbox.hpp"
#include "run/silence.hpp"
#include "surefoot/safety.hpp"
#include "surefoot/stand_runner.hpp"

namespace surefoot {

/// What a StandRunner does in a tick: which commands leave, and why. It knows no clock of its own.
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
  void stop() noexcept { stop_.store(true); }
  void damp() noexcept { damp_.store(true); }
  void rearm() noexcept { rearm_.store(true); }

  // From any thread:
  void set_gains(const Gains& gains);  ///< throws surefoot::Error
  void set_body_reference(const BodyReference& target) { reference_letter_.put(target); }

  /// How it is, but for what only the clock knows. Real-time: yes.
  const RunSnapshot& describe() noexcept;
  /// Has it latched since this was asked last? Real-time: yes.
  bool has_news() noexcept;
  int local_port() const noexcept { return link_.local_port(); }

 private:
  void wait_for_robot() noexcept;
  void stand(bool newer, double elapsed) noexcept;
  void control(const LowState& state) noexcept;
  void bridge(double age, double elapsed) noexcept;
  void stay_damped(bool newer, bool rearmed) noexcept;
  void obey_letters() noexcept;
  void obey_remote() noexcept;
  void begin() noexcept;
  void latch(RunReason why) noexcept;
  void end(RunReason why) noexcept;

  RunOptions options_;
  StandController controller_;
  Safety safety_;
  UdpLink link_;
  Vector12 tau_max_;  // [N.m]
  LowCmd damping_, last_ = damping_;
  Gains gains_;
  BodyReference asked_;  // besides what the remote asks for
  Mailbox<Gains> gains_letter_;
  Mailbox<BodyReference> reference_letter_;
  Silence silence_;
  RunSnapshot now_;
  double begun_ = 0.0;          // [s] when control began first
  std::uint64_t restarts_ = 0;  // of the robot, when control began
  bool news_ = false;
  std::atomic<bool> stop_{false}, damp_{false}, rearm_{false};
};

}  // namespace surefoot
