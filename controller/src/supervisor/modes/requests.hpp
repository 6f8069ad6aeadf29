// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>

#include "surefoot/supervisor_enums.hpp"

namespace surefoot {

/// State of the supervisor from which judge_request() and judge_arming() decide whether a request
/// is accepted. Each tick publishes this state.
struct RequestContext {
  Mode mode = Mode::kPassive;
  bool state_valid = false;  ///< true if valid samples arrive
  bool armed = false;
  bool ready = false;          ///< true if all arming checks have passed for arming_time
  bool must_sit = false;       ///< true if a fault, a lost leg or a conflict forbids a rise
  bool fading = false;         ///< true if torques fade between modes
  bool checks_waived = false;  ///< true for Start::kStanding: arm() needs no checks
  bool must_stand = false;     ///< true if a fault or a lost leg forbids walking
  bool can_walk = true;        ///< WalkController::can_walk()
  bool stopping = false;       ///< true if the feet step until the robot stands or sits down
};

/// Return whether `mode` may be entered now, or the reason why not. Real-time: yes.
RequestStatus judge_request(const RequestContext& context, Mode mode) noexcept;
/// Return whether the robot may be armed now, or the reason why not. Real-time: yes.
RequestStatus judge_arming(const RequestContext& context) noexcept;

/// Mailbox for requests from any thread to the tick. It holds one request; while it is full,
/// further requests return kBusy. A stop has a flag of its own and is never rejected. The class
/// uses no locks. Real-time: yes.
class Requests {
 public:
  // For any thread:
  RequestStatus request_mode(Mode mode) noexcept;
  RequestStatus request_arming() noexcept;
  /// Request that the next tick latches damping. This request is never rejected.
  void stop() noexcept { stop_.store(true); }
  RequestContext context() const noexcept { return unpack(context_.load()); }

  // For the tick:
  void publish(const RequestContext& context) noexcept { context_.store(pack(context)); }
  bool take_stop() noexcept { return stop_.exchange(false); }
  // Requests that are not a Mode; a Mode is 0 or more, and less than kArm.
  static constexpr int kNoRequest = -1, kArm = 100;
  /// Remove and return the pending request: a Mode, kArm or kNoRequest.
  int take() noexcept { return pending_.exchange(kNoRequest); }

 private:
  static int pack(const RequestContext& context) noexcept;
  static RequestContext unpack(int bits) noexcept;
  RequestStatus post(int request) noexcept;

  std::atomic<int> pending_{kNoRequest};
  std::atomic<int> context_{0};
  std::atomic<bool> stop_{false};
};

}  // namespace surefoot
