// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>

#include "surefoot/supervisor.hpp"

namespace surefoot {

/// What requests are judged by; published by the tick.
struct RequestContext {
  Mode mode = Mode::kPassive;
  bool seen = false;  ///< does a valid LowState come?
  bool armed = false;
  bool ready = false;     ///< have all arming checks passed for long enough?
  bool must_sit = false;  ///< does a fault keep it down?
  bool fading = false;    ///< are torques on their way from mode to mode?
  bool trusted = false;   ///< does arming ask for no checks?
};

/// May `mode` be entered from here?
RequestStatus judge_request(const RequestContext& now, Mode mode) noexcept;
RequestStatus judge_arming(const RequestContext& now) noexcept;

/// Where other threads leave what they want, for the tick to take: one thing at a time, except that
/// a stop always gets through. Lock-free. Real-time: yes.
class Requests {
 public:
  // From any thread:
  RequestStatus ask(Mode mode) noexcept;
  RequestStatus ask_to_arm() noexcept;
  void stop() noexcept { stop_.store(true); }
  RequestContext context() const noexcept { return unpack(context_.load()); }

  // From the tick:
  void publish(const RequestContext& now) noexcept { context_.store(pack(now)); }
  bool take_stop() noexcept { return stop_.exchange(false); }
  static constexpr int kNothing = -1, kArm = 100;
  int take() noexcept { return waiting_.exchange(kNothing); }  ///< a Mode, kArm or kNothing

 private:
  static int pack(const RequestContext& now) noexcept;
  static RequestContext unpack(int bits) noexcept;
  RequestStatus leave(int what) noexcept;

  std::atomic<int> waiting_{kNothing};
  std::atomic<int> context_{0};
  std::atomic<bool> stop_{false};
};

}  // namespace surefoot
