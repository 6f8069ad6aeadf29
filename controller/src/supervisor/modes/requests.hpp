// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>

#include "surefoot/mode.hpp"

namespace surefoot {

/// What requests are judged by; published by the tick.
struct RequestContext {
  Mode mode = Mode::kPassive;
  bool state_valid = false;  ///< does a valid LowState come?
  bool armed = false;
  bool ready = false;          ///< have all arming checks passed for long enough?
  bool must_sit = false;       ///< does a fault keep it down?
  bool fading = false;         ///< are torques on their way from mode to mode?
  bool checks_waived = false;  ///< does arming ask for no checks?
};

/// May `mode` be entered from here?
RequestStatus judge_request(const RequestContext& context, Mode mode) noexcept;
RequestStatus judge_arming(const RequestContext& context) noexcept;

/// Where other threads leave what they want, for the tick to take: one thing at a time, except that
/// a stop always gets through. Lock-free. Real-time: yes.
class Requests {
 public:
  // From any thread:
  RequestStatus request_mode(Mode mode) noexcept;
  RequestStatus request_arming() noexcept;
  void stop() noexcept { stop_.store(true); }
  RequestContext context() const noexcept { return unpack(context_.load()); }

  // From the tick:
  void publish(const RequestContext& context) noexcept { context_.store(pack(context)); }
  bool take_stop() noexcept { return stop_.exchange(false); }
  static constexpr int kNoRequest = -1, kArm = 100;
  int take() noexcept { return pending_.exchange(kNoRequest); }  ///< a Mode, kArm or kNoRequest

 private:
  static int pack(const RequestContext& context) noexcept;
  static RequestContext unpack(int bits) noexcept;
  RequestStatus post(int request) noexcept;

  std::atomic<int> pending_{kNoRequest};
  std::atomic<int> context_{0};
  std::atomic<bool> stop_{false};
};

}  // namespace surefoot
