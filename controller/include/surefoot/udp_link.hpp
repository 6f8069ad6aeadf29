// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>

#include "surefoot/frames.hpp"

namespace surefoot {

/// Where the robot is and what it speaks.
struct UdpLinkOptions {
  std::string host = "127.0.0.1";  ///< IPv4 address or name; a real robot is 192.168.123.10
  int port = 8007;
  int local_port = 0;  ///< 0: any; the SDK's examples use 8080 or 8090
  Generation generation = Generation::kGo1v38;
  double damping_kd = 3.0;  ///< [N.m.s/rad] 0.0625 .. 50, before the robot is known
  bool real_robot = false;  ///< may the peer be beyond this machine's loopback?
};

/// What has come and gone since the link was opened.
struct LinkCounts {
  std::uint64_t sent = 0;
  std::uint64_t send_failed = 0;  ///< the system would not take it
  std::uint64_t refused = 0;      ///< commands that were not finite; damping left instead
  std::uint64_t received = 0;     ///< datagrams of the peer, good or bad
  std::uint64_t valid = 0;        ///< LowStates of the right generation
  std::uint64_t lost = 0;         ///< missing in the row of ticks, long silences included
  std::uint64_t late = 0;         ///< the newest, but more than 10 ms after the one before
  std::uint64_t duplicate = 0;    ///< a tick that had come before
  std::uint64_t reordered = 0;    ///< older than the newest, and had not come yet
  std::uint64_t restarts = 0;     ///< times that the ticks began anew: five in a row from behind
  std::uint64_t corrupt = 0;      ///< of the right length, but not a valid frame
  std::uint64_t wrong_generation = 0;
  std::uint64_t wrong_length = 0;
  std::uint64_t strangers = 0;  ///< datagrams from someone else
  std::uint64_t floods = 0;     ///< times more was waiting than is read at once
};

/// The client's side of the robot's UDP port.
///
/// Datagrams count only if they come from the peer. Until a valid LowState has shown that the robot
/// speaks the generation that is expected, nothing but damping leaves, whatever is sent. The age of
/// a state counts from its arrival on this machine: what waited while this program stood still is
/// as old as it is.
class UdpLink {
 public:
  /// Throws surefoot::Error: an unknown host, a peer beyond this machine's loopback without
  /// UdpLinkOptions::real_robot, a port that is out of range, taken or forbidden, a damping_kd that
  /// is out of range.
  explicit UdpLink(const UdpLinkOptions& options);
  ~UdpLink();
  UdpLink(UdpLink&&) noexcept;

  /// Read what is waiting, at most kMaxDatagramsPerReceive datagrams; the newest valid LowState
  /// wins. Never blocks. Real-time: yes. @return has a newer one come? See state_age() for how new
  /// it is
  bool receive() noexcept;
  static constexpr int kMaxDatagramsPerReceive = 64;

  /// Put a command on the wire; damping instead until the robot has answered (has_state()), or if
  /// the command is not finite. Never blocks. Real-time: yes.
  /// @return how it was encoded; kNotFinite: damping left instead
  FrameReport send(const LowCmd& cmd) noexcept;

  bool has_state() const noexcept;         ///< has a valid LowState come?
  const LowState& state() const noexcept;  ///< the newest
  const FrameExtras& extras() const noexcept;
  double state_age() const noexcept;  ///< [s] since it arrived; infinite before the first
  const LinkCounts& counts() const noexcept;
  const FrameReport& last_reject() const noexcept;  ///< why the last bad datagram was not taken
  int local_port() const noexcept;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace surefoot
