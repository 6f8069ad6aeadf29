// SPDX-License-Identifier: BSD-3-Clause
#include "supervisor/requests.hpp"

namespace surefoot {

RequestStatus judge_request(const RequestContext& now, Mode mode) noexcept {
  if (!now.seen) return RequestStatus::kNoState;
  if (now.mode == Mode::kDamping) return RequestStatus::kLatched;
  if (!now.armed) return RequestStatus::kNotArmed;
  const bool lying = now.mode == Mode::kPassive;
  const bool up = now.mode == Mode::kRise || now.mode == Mode::kStand;
  const bool fits = (mode == Mode::kRise && lying) || (mode == Mode::kSit && up) ||
                    (mode == Mode::kStand && now.mode == Mode::kSit);
  if (!fits) return RequestStatus::kOutOfOrder;
  if ((lying && !now.ready) || (mode != Mode::kSit && now.must_sit)) {
    return RequestStatus::kNotReady;
  }
  // A rise may be aborted at any time: what fades in just fades out again.
  const bool busy = now.fading && now.mode != Mode::kRise;
  return busy ? RequestStatus::kBusy : RequestStatus::kAccepted;
}

RequestStatus judge_arming(const RequestContext& now) noexcept {
  if (!now.seen) return RequestStatus::kNoState;
  if (now.mode != Mode::kPassive && now.mode != Mode::kDamping) return RequestStatus::kOutOfOrder;
  const bool may = now.ready || (now.trusted && !now.must_sit);
  return may ? RequestStatus::kAccepted : RequestStatus::kNotReady;
}

RequestStatus Requests::ask(Mode mode) noexcept {
  const RequestStatus judged = judge_request(context(), mode);
  return judged == RequestStatus::kAccepted ? leave(static_cast<int>(mode)) : judged;
}

RequestStatus Requests::ask_to_arm() noexcept {
  const RequestStatus judged = judge_arming(context());
  return judged == RequestStatus::kAccepted ? leave(kArm) : judged;
}

RequestStatus Requests::leave(int what) noexcept {
  if (stop_.load()) return RequestStatus::kBusy;  // it would void this
  int nothing = kNothing;
  const bool mine = waiting_.compare_exchange_strong(nothing, what);
  return mine ? RequestStatus::kAccepted : RequestStatus::kBusy;
}

int Requests::pack(const RequestContext& now) noexcept {
  return static_cast<int>(now.mode) | now.seen << 8 | now.armed << 9 | now.ready << 10 |
         now.fading << 11 | now.must_sit << 12 | now.trusted << 13;
}

RequestContext Requests::unpack(int bits) noexcept {
  return {static_cast<Mode>(bits & 0xFF), (bits >> 8 & 1) != 0,  (bits >> 9 & 1) != 0,
          (bits >> 10 & 1) != 0,          (bits >> 12 & 1) != 0, (bits >> 11 & 1) != 0,
          (bits >> 13 & 1) != 0};
}

}  // namespace surefoot
