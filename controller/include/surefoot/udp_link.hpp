// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>

#include "surefoot/frames.hpp"

namespace surefoot {

/// Options of a UdpLink: address of the robot and format of its frames.
struct UdpLinkOptions {
  std::string host = "127.0.0.1";  ///< IPv4 address or name; real robot: 192.168.123.10
  int port = 8007;                 ///< UDP port of the robot, 1 .. 65535
  int local_port = 0;              ///< local UDP port; 0: any free port. SDK examples: 8080, 8090
  Generation generation = Generation::kGo1v38;  ///< frame format of the robot
  /// [N.m.s/rad] Kd in the damping frames that the link itself sends, 0.0625 .. 50.
  double damping_kd = 3.0;
  bool real_robot = false;  ///< true: any host is allowed; false: only a loopback address
};

/// Counts of frames sent and datagrams received since the link was opened.
struct LinkCounts {
  std::uint64_t sent = 0;         ///< frames sent, damping included
  std::uint64_t send_failed = 0;  ///< frames that the system did not accept
  std::uint64_t refused = 0;      ///< commands that were not finite; damping was sent instead
  std::uint64_t received = 0;     ///< datagrams from the peer, valid or not
  std::uint64_t valid = 0;        ///< valid LowStates of the expected generation
  std::uint64_t lost = 0;         ///< LowStates that are missing in the tick sequence
  std::uint64_t late = 0;  ///< new LowStates that arrived more than 10 ms after the previous one
  std::uint64_t duplicate = 0;  ///< LowStates whose tick had already arrived
  std::uint64_t reordered = 0;  ///< LowStates counted as lost, then received after a newer one
  /// Restarts of the robot: five consecutive LowStates whose ticks increase but are all older than
  /// the newest tick.
  std::uint64_t restarts = 0;
  std::uint64_t corrupt = 0;  ///< datagrams with the right length but no valid frame in them
  std::uint64_t wrong_generation = 0;  ///< frames of another generation
  std::uint64_t wrong_length = 0;      ///< datagrams whose length fits no generation
  std::uint64_t strangers = 0;         ///< datagrams from other senders than the peer
  std::uint64_t floods = 0;  ///< calls of receive() that read the maximum number of datagrams
};

/// Client of the robot's UDP port: sends LowCmd frames, receives LowState frames.
///
/// Datagrams from other senders than the peer are ignored. Until a valid LowState has shown that
/// the robot uses the expected generation, only damping frames are sent, whatever command is given.
/// state_age() is measured from the arrival of the LowState at this machine, so the time that a
/// LowState waits in the socket is included. Not thread-safe.
class UdpLink {
 public:
  /// Open the link. Throws surefoot::Error if the host is unknown, if the host is not a loopback
  /// address and UdpLinkOptions::real_robot is false, if a port is out of range, in use or not
  /// permitted, or if damping_kd is out of range.
  explicit UdpLink(const UdpLinkOptions& options);
  ~UdpLink();
  /// Take over the content of another UdpLink, which may only be destroyed afterwards.
  UdpLink(UdpLink&&) noexcept;

  /// Read the waiting datagrams, at most kMaxDatagramsPerReceive, and keep the newest valid
  /// LowState. Never blocks. Real-time: yes.
  /// @return true if a newer LowState has arrived; see state_age() for its age
  bool receive() noexcept;
  static constexpr int kMaxDatagramsPerReceive = 64;  ///< most datagrams that receive() reads

  /// Send a command. Until has_state() is true, or if the command is not finite, a damping frame is
  /// sent instead. Never blocks. Real-time: yes.
  /// @return how the command was encoded; kNotFinite: damping was sent instead
  FrameReport send(const LowCmd& cmd) noexcept;

  bool has_state() const noexcept;             ///< true once a valid LowState has arrived
  const LowState& state() const noexcept;      ///< newest LowState
  const FrameExtras& extras() const noexcept;  ///< extras of the newest LowState
  double state_age() const noexcept;  ///< [s] time since state() arrived; infinity before the first
  const LinkCounts& counts() const noexcept;        ///< counts since the link was opened
  const FrameReport& last_reject() const noexcept;  ///< why the last invalid datagram was rejected
  int local_port() const noexcept;                  ///< local UDP port

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace surefoot
