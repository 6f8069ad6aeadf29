// SPDX-License-Identifier: BSD-3-Clause
#include "surefoot/udp_link.hpp"

#include <algorithm>

#include "common/clock.hpp"
#include "common/text.hpp"
#include "link/state_intake.hpp"
#include "link/udp_socket.hpp"
#include "surefoot/error.hpp"

namespace surefoot {

namespace {

// [N.m.s/rad] Range of UdpLinkOptions::damping_kd, equal to the range of Gains::damping_kd.
// Derived: the minimum is the smallest Kd that a frame can encode, 1/16 (kDampingUnit).
constexpr double kMinKd = 0.0625, kMaxKd = 50.0;

LowCmd checked_damping(double kd) {
  if (kd >= kMinKd && kd <= kMaxKd) return damping_low_cmd(kd);
  throw Error("damping_kd: got " + to_text(kd) + ", expected " + to_text(kMinKd) + " .. " +
              to_text(kMaxKd) + " [N.m.s/rad]");
}

}  // namespace

struct UdpLink::Impl {
  explicit Impl(const UdpLinkOptions& o)
      : options(o),
        socket(o.host, o.port, o.local_port, o.real_robot),
        damping(checked_damping(o.damping_kd)) {
    encode_low_cmd(damping, FrameExtras{}, options.generation, damping_frame);
  }
  bool process_datagram(std::size_t size, double time) noexcept;

  UdpLinkOptions options;
  UdpSocket socket;
  LowCmd damping;
  // Larger than the largest frame, so that datagrams that are too long are detected.
  std::array<std::uint8_t, 2 * kMaxFrameSize> buffer{};
  Frame frame, damping_frame;
  LowState incoming = init_low_state();
  FrameExtras extras, incoming_extras;
  StateIntake intake;
};

UdpLink::UdpLink(const UdpLinkOptions& options) : impl_(std::make_unique<Impl>(options)) {}
UdpLink::~UdpLink() = default;
UdpLink::UdpLink(UdpLink&&) noexcept = default;

bool UdpLink::receive() noexcept {
  Impl& s = *impl_;
  bool newer = false;
  for (int k = 0; k < kMaxDatagramsPerReceive; ++k) {
    std::size_t size = s.buffer.size();
    double arrival_stamp = 0.0;  // [s] arrival time of the datagram
    const UdpSocket::ReadResult read = s.socket.read(s.buffer.data(), size, arrival_stamp);
    if (read == UdpSocket::ReadResult::kNothing) return newer;
    if (read == UdpSocket::ReadResult::kOtherSender) {
      ++s.intake.status.counts.strangers;
    } else {
      newer = s.process_datagram(size, arrival_stamp) || newer;
    }
  }
  ++s.intake.status.counts.floods;
  return newer;
}

// Process a datagram from the peer: decode it and count it. Store the LowState if it is newer than
// the stored one, or if the robot has restarted. Return whether the LowState was stored. Invalid,
// duplicate and reordered datagrams are only counted.
// @param time arrival time of the datagram [s], on monotonic_time()
bool UdpLink::Impl::process_datagram(std::size_t size, double time) noexcept {
  ++intake.status.counts.received;
  const FrameReport report = decode_low_state(buffer.data(), std::min(size, buffer.size()),
                                              options.generation, incoming, incoming_extras);
  if (report.status != FrameStatus::kOk) {
    intake.reject(report);
    return false;
  }
  if (!intake.accept(incoming, time)) return false;
  extras = incoming_extras;
  return true;
}

FrameReport UdpLink::send(const LowCmd& cmd) noexcept {
  Impl& s = *impl_;
  const FrameReport report = encode_low_cmd(cmd, FrameExtras{}, s.options.generation, s.frame);
  const bool usable = is_usable(report.status);
  if (!usable) ++s.intake.status.counts.refused;
  const Frame& outgoing = usable && s.intake.status.has_state ? s.frame : s.damping_frame;
  const bool was_sent = s.socket.write(outgoing.bytes.data(), outgoing.size);
  ++(was_sent ? s.intake.status.counts.sent : s.intake.status.counts.send_failed);
  return report;
}

const LinkStatus& UdpLink::status() const noexcept { return impl_->intake.status; }
bool UdpLink::allows_real_robot() const noexcept { return impl_->options.real_robot; }
const FrameExtras& UdpLink::extras() const noexcept { return impl_->extras; }
int UdpLink::local_port() const noexcept { return impl_->socket.local_port(); }

}  // namespace surefoot
