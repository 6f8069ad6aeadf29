// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>

#include "surefoot/robot_link.hpp"

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

/// Client of the robot's UDP port: sends LowCmd frames, receives LowState frames.
///
/// Datagrams from other senders than the peer are ignored. Until a valid LowState has shown that
/// the robot uses the expected generation, only damping frames are sent, whatever command is given.
/// state_age() is measured from the arrival of the LowState at this machine, so the time that a
/// LowState waits in the socket is included. Not thread-safe.
class UdpLink final : public RobotLink {
 public:
  /// Open the link. Throws surefoot::Error if the host is unknown, if the host is not a loopback
  /// address and UdpLinkOptions::real_robot is false, if a port is out of range, in use or not
  /// permitted, or if damping_kd is out of range.
  explicit UdpLink(const UdpLinkOptions& options);
  ~UdpLink() override;
  /// Take over the content of another UdpLink, which may only be destroyed afterwards.
  UdpLink(UdpLink&&) noexcept;

  /// Read the waiting datagrams, at most kMaxDatagramsPerReceive, and keep the newest valid
  /// LowState. Never blocks. Real-time: yes.
  /// @return true if a newer LowState has arrived; see state_age() for its age
  bool receive() noexcept override;
  static constexpr int kMaxDatagramsPerReceive = 64;  ///< most datagrams that receive() reads

  /// Send a command. Until has_state() is true, or if the command is not finite, a damping frame is
  /// sent instead. Never blocks. Real-time: yes.
  /// @return how the command was encoded; kNotFinite: damping was sent instead
  FrameReport send(const LowCmd& cmd) noexcept override;
  const LinkStatus& status() const noexcept override;  ///< present state of the link
  bool allows_real_robot() const noexcept override;    ///< UdpLinkOptions::real_robot

  const FrameExtras& extras() const noexcept;  ///< extras of the newest LowState
  int local_port() const noexcept;             ///< local UDP port

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace surefoot
