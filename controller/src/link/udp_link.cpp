// SPDX-License-Identifier: BSD-3-Clause
#include "surefoot/udp_link.hpp"

#include <algorithm>
#include <limits>

#include "clock.hpp"
#include "link/tick_sequence.hpp"
#include "link/udp_socket.hpp"
#include "safety/command_keeper.hpp"
#include "surefoot/error.hpp"
#include "text.hpp"

namespace surefoot {

namespace {

constexpr double kLeastKd = 0.0625, kGreatestKd = 50.0;  // [N.m.s/rad] Gains::damping_kd's range

LowCmd checked_damping(double kd) {
  if (kd >= kLeastKd && kd <= kGreatestKd) return damping_low_cmd(kd);
  throw Error("damping_kd: got " + to_text(kd) + ", expected " + to_text(kLeastKd) + " .. " +
              to_text(kGreatestKd) + " [N.m.s/rad]");
}

}  // namespace

struct UdpLink::Impl {
  explicit Impl(const UdpLinkOptions& o)
      : options(o),
        socket(o.host, o.port, o.local_port, o.real_robot),
        damping(checked_damping(o.damping_kd)) {
    encode_low_cmd(damping, FrameExtras{}, options.generation, damping_frame);
  }
  bool take(std::size_t size, double time) noexcept;
  void reject(const FrameReport& report) noexcept;

  UdpLinkOptions options;
  UdpSocket socket;
  LowCmd damping;
  std::array<std::uint8_t, 2 * kMaxFrame> buffer{};  // room to see that a datagram is too long
  Frame frame, damping_frame;
  LowState state = init_low_state(), incoming = state;
  FrameExtras extras, incoming_extras;
  TickSequence sequence;
  LinkCounts counts;
  FrameReport last_reject;
  bool known = false;
  double arrived = 0.0;  // [s] of the newest, on monotonic_time()
};

UdpLink::UdpLink(const UdpLinkOptions& options) : impl_(std::make_unique<Impl>(options)) {}
UdpLink::~UdpLink() = default;
UdpLink::UdpLink(UdpLink&&) noexcept = default;

bool UdpLink::receive() noexcept {
  Impl& s = *impl_;
  bool newer = false;
  for (int k = 0; k < kMostAtOnce; ++k) {
    std::size_t size = s.buffer.size();
    double arrived = 0.0;
    const UdpSocket::Read read = s.socket.read(s.buffer.data(), size, arrived);
    if (read == UdpSocket::Read::kNothing) return newer;
    if (read == UdpSocket::Read::kStranger) {
      ++s.counts.strangers;
    } else {
      newer = s.take(size, arrived) || newer;
    }
  }
  ++s.counts.floods;
  return newer;
}

// One datagram of the peer. Is it newer than what there is?
bool UdpLink::Impl::take(std::size_t size, double time) noexcept {
  ++counts.received;
  const FrameReport report = decode_low_state(buffer.data(), std::min(size, buffer.size()),
                                              options.generation, incoming, incoming_extras);
  if (report.status != FrameStatus::kOk) {
    reject(report);
    return false;
  }
  ++counts.valid;
  const TickSequence::Verdict verdict = sequence.take(incoming.tick, time);
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
  const FrameReport report = encode_low_cmd(cmd, FrameExtras{}, s.options.generation, s.frame);
  const bool usable = is_usable(report.status);
  if (!usable) ++s.counts.refused;
  const Frame& leaves = usable && s.known ? s.frame : s.damping_frame;
  const bool gone = s.socket.write(leaves.bytes.data(), leaves.size);
  ++(gone ? s.counts.sent : s.counts.send_failed);
  return report;
}

bool UdpLink::known() const noexcept { return impl_->known; }
const LowState& UdpLink::state() const noexcept { return impl_->state; }
const FrameExtras& UdpLink::extras() const noexcept { return impl_->extras; }
double UdpLink::age() const noexcept {
  return impl_->known ? monotonic_time() - impl_->arrived : std::numeric_limits<double>::infinity();
}
const LinkCounts& UdpLink::counts() const noexcept { return impl_->counts; }
const FrameReport& UdpLink::last_reject() const noexcept { return impl_->last_reject; }
int UdpLink::local_port() const noexcept { return impl_->socket.local_port(); }

}  // namespace surefoot
