// SPDX-License-Identifier: BSD-3-Clause
#include "supervisor/modes/requests.hpp"

namespace surefoot {

RequestStatus judge_request(const RequestContext& context, Mode mode) noexcept {
  if (!context.state_valid) return RequestStatus::kNoState;
  if (context.mode == Mode::kDamping) return RequestStatus::kLatched;
  if (!context.armed) return RequestStatus::kNotArmed;
  const bool lying = context.mode == Mode::kPassive;
  const bool up = context.mode == Mode::kRise || context.mode == Mode::kStand;
  const bool mode_allowed = (mode == Mode::kRise && lying) || (mode == Mode::kSit && up) ||
                            (mode == Mode::kStand && context.mode == Mode::kSit);
  if (!mode_allowed) return RequestStatus::kOutOfOrder;
  if ((lying && !context.ready) || (mode != Mode::kSit && context.must_sit)) {
    return RequestStatus::kNotReady;
  }
  // A rise may be interrupted even during its fade, because TorqueFade can reverse a fade.
  const bool busy = context.fading && context.mode != Mode::kRise;
  return busy ? RequestStatus::kBusy : RequestStatus::kAccepted;
}

RequestStatus judge_arming(const RequestContext& context) noexcept {
  if (!context.state_valid) return RequestStatus::kNoState;
  if (context.mode != Mode::kPassive && context.mode != Mode::kDamping)
    return RequestStatus::kOutOfOrder;
  const bool arming_allowed = context.ready || (context.checks_waived && !context.must_sit);
  return arming_allowed ? RequestStatus::kAccepted : RequestStatus::kNotReady;
}

RequestStatus Requests::request_mode(Mode mode) noexcept {
  const RequestStatus judged = judge_request(context(), mode);
  return judged == RequestStatus::kAccepted ? post(static_cast<int>(mode)) : judged;
}

RequestStatus Requests::request_arming() noexcept {
  const RequestStatus judged = judge_arming(context());
  return judged == RequestStatus::kAccepted ? post(kArm) : judged;
}

RequestStatus Requests::post(int request) noexcept {
  if (stop_.load()) return RequestStatus::kBusy;  // the stop would cancel this request
  int expected = kNoRequest;
  const bool posted = pending_.compare_exchange_strong(expected, request);
  return posted ? RequestStatus::kAccepted : RequestStatus::kBusy;
}

// Bits: 0 .. 7 mode, 8 state_valid, 9 armed, 10 ready, 11 fading, 12 must_sit, 13 checks_waived.
int Requests::pack(const RequestContext& context) noexcept {
  return static_cast<int>(context.mode) | context.state_valid << 8 | context.armed << 9 |
         context.ready << 10 | context.fading << 11 | context.must_sit << 12 |
         context.checks_waived << 13;
}

// In the struct, must_sit (bit 12) comes before fading (bit 11).
RequestContext Requests::unpack(int bits) noexcept {
  return {static_cast<Mode>(bits & 0xFF), (bits >> 8 & 1) != 0,  (bits >> 9 & 1) != 0,
          (bits >> 10 & 1) != 0,          (bits >> 12 & 1) != 0, (bits >> 11 & 1) != 0,
          (bits >> 13 & 1) != 0};
}

}  // namespace surefoot
