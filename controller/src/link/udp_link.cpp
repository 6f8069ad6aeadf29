// SPDX-License-Identifier: BSD-3-Clause
#include "surefoot/udp_link.hpp"

#include <chrono>
#include <limits>

#include "link/tick_sequence.hpp"
#include "link/udp_socket.hpp"
#include "safety/command_keeper.hpp"

namespace surefoot {

namespace {

double now() noexcept {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

struct UdpLink::Impl {
  explicit Impl(const UdpLinkOptions& o)
      : options(o), socket(o.host, o.port, o.local_port), damping(damping_low_cmd(o.damping_kd)) {}
  bool take(std::size_t size) noexcept;
  void reject(const FrameReport& report) noexcept;

  UdpLinkOptions options;
  UdpSocket socket;
  LowCmd damping;
  std::array<std::uint8_t, 2 * kMaxFrame> buffer{};  // room to see that a datagram is too long
  Frame frame;
  LowState state = init_low_state(), incoming = state;
  FrameExtras extras, incoming_extras;
  TickSequence sequence;
  LinkCounts counts;
  FrameReport last_reject;
  bool known = false;
  double arrived = 0.0;  // [s] of the newest, on the steady clock
};

UdpLink::UdpLink(const UdpLinkOptions& options) : impl_(std::make_unique<Impl>(options)) {}
UdpLink::~UdpLink() = default;
UdpLink::UdpLink(UdpLink&&) noexcept = default;

bool UdpLink::receive() noexcept {
  Impl& s = *impl_;
  bool newer = false;
  for (int k = 0; k < kMostAtOnce; ++k) {
    std::size_t size = s.buffer.size();
    const UdpSocket::Read read = s.socket.read(s.buffer.data(), size);
    if (read == UdpSocket::Read::kNothing) return newer;
    if (read == UdpSocket::Read::kStranger) {
      ++s.counts.strangers;
    } else {
      newer = s.take(size) || newer;
    }
  }
  ++s.counts.floods;
  return newer;
}

// One datagram of the peer. Is it newer than what there is?
bool UdpLink::Impl::take(std::size_t size) noexcept {
  ++counts.received;
  const FrameReport report = decode_low_state(buffer.data(), std::min(size, buffer.size()),
                                              options.generation, incoming, incoming_extras);
  if (report.status != FrameStatus::kOk) {
    reject(report);
    return false;
  }
  ++counts.valid;
  const TickSequence::Verdict verdict = sequence.take(incoming.tick);
  counts.lost = sequence.lost();
  if (verdict == TickSequence::Verdict::kDuplicate) {
    ++counts.duplicate;
    return false;
  }
  if (verdict == TickSequence::Verdict::kReordered) {
    ++counts.reordered;
    return false;
  }
  if (verdict == TickSequence::Verdict::kRestarted) ++counts.restarts;
  const double time = now();
  if (known && time - arrived > kHoldTime) ++counts.late;
  known = true;
  arrived = time;
  state = incoming;
  extras = incoming_extras;
  return true;
}

void UdpLink::Impl::reject(const FrameReport& report) noexcept {
  last_reject = report;
  switch (report.status) {
    case FrameStatus::kWrongGeneration:
      ++counts.wrong_generation;
      break;
    case FrameStatus::kWrongLength:
      ++counts.wrong_length;
      break;
    default:
      ++counts.corrupt;
  }
}

FrameReport UdpLink::send(const LowCmd& cmd) noexcept {
  Impl& s = *impl_;
  FrameReport report =
      encode_low_cmd(s.known ? cmd : s.damping, FrameExtras{}, s.options.generation, s.frame);
  if (!is_usable(report.status)) {
    ++s.counts.refused;
    encode_low_cmd(s.damping, FrameExtras{}, s.options.generation, s.frame);
  }
  const bool gone = s.socket.write(s.frame.bytes.data(), s.frame.size);
  ++(gone ? s.counts.sent : s.counts.send_failed);
  return report;
}

bool UdpLink::known() const noexcept { return impl_->known; }
const LowState& UdpLink::state() const noexcept { return impl_->state; }
const FrameExtras& UdpLink::extras() const noexcept { return impl_->extras; }
double UdpLink::age() const noexcept {
  return impl_->known ? now() - impl_->arrived : std::numeric_limits<double>::infinity();
}
const LinkCounts& UdpLink::counts() const noexcept { return impl_->counts; }
const FrameReport& UdpLink::last_reject() const noexcept { return impl_->last_reject; }
int UdpLink::local_port() const noexcept { return impl_->socket.local_port(); }

}  // namespace surefoot
