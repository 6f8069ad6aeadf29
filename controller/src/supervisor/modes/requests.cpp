// SPDX-License-Identifier: BSD-3-Clause
#include "supervisor/modes/requests.hpp"

namespace surefoot {

namespace {

// Return whether a request may change the mode from `present` to `next`.
bool follows(Mode present, Mode next) noexcept {
  switch (next) {
    case Mode::kRise:
      return present == Mode::kPassive;
    case Mode::kStand:
      return present == Mode::kSit || present == Mode::kWalk;
    case Mode::kWalk:
      return present == Mode::kStand;
    case Mode::kSit:
      return present == Mode::kRise || present == Mode::kStand || present == Mode::kWalk;
    default:
      return false;
  }
}

}  // namespace

RequestStatus judge_request(const RequestContext& context, Mode mode) noexcept {
  if (!context.state_valid) return RequestStatus::kNoState;
  if (context.mode == Mode::kDamping) return RequestStatus::kLatched;
  if (!context.armed) return RequestStatus::kNotArmed;
  const bool lying = context.mode == Mode::kPassive;
  if (!follows(context.mode, mode)) return RequestStatus::kOutOfOrder;
  if (mode == Mode::kWalk && !context.can_walk) return RequestStatus::kCannotWalk;
  if ((lying && !context.ready) || (mode != Mode::kSit && context.must_sit) ||
      (mode == Mode::kWalk && context.must_stand)) {
    return RequestStatus::kNotReady;
  }
  if (mode == Mode::kWalk && context.stopping) return RequestStatus::kBusy;
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

// Bits: 0 .. 7 mode, then the flags of the struct in their order.
int Requests::pack(const RequestContext& context) noexcept {
  return static_cast<int>(context.mode) | context.state_valid << 8 | context.armed << 9 |
         context.ready << 10 | context.must_sit << 11 | context.fading << 12 |
         context.checks_waived << 13 | context.must_stand << 14 | context.can_walk << 15 |
         context.stopping << 16;
}

RequestContext Requests::unpack(int bits) noexcept {
  const auto flag = [bits](int bit) { return (bits >> bit & 1) != 0; };
  return {static_cast<Mode>(bits & 0xFF),
          flag(8),
          flag(9),
          flag(10),
          flag(11),
          flag(12),
          flag(13),
          flag(14),
          flag(15),
          flag(16)};
}

}  // namespace surefoot
