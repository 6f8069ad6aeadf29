// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace surefoot {

/// When a datagram arrived [s], on monotonic_time(), by the age that its stamp tells of. Stamps are
/// the wall clock's, which steps where nothing happened: it is no older than the last time that
/// there was nothing to read, and no younger than now. Real-time: yes.
/// @param now, last_empty [s] on monotonic_time() @param age [s]
double arrival_time(double now, double age, double last_empty) noexcept;

/// A non-blocking IPv4 socket that talks to one peer. Real-time: read() and write() yes.
class UdpSocket {
 public:
  /// Throws surefoot::Error. @param allow_remote_peer may the peer be beyond this machine?
  UdpSocket(const std::string& host, int port, int local_port, bool allow_remote_peer);
  ~UdpSocket();
  UdpSocket(const UdpSocket&) = delete;
  UdpSocket& operator=(const UdpSocket&) = delete;

  enum class ReadResult { kNothing, kPeer, kOtherSender };
  /// Take one datagram.
  /// @param size in: room; out: its length, which may be more than the room
  /// @param arrived [s] out: on monotonic_time(), when it reached this machine, not this program
  ReadResult read(std::uint8_t* data, std::size_t& size, double& arrived) noexcept;

  bool write(const std::uint8_t* data, std::size_t size) noexcept;

  int local_port() const noexcept { return local_port_; }

 private:
  int fd_ = -1;
  double last_empty_time_ = 0.0;  // [s] on monotonic_time(), when there was nothing to read last
  int local_port_ = 0;
  std::uint32_t peer_address_ = 0;  // network order
  std::uint16_t peer_port_ = 0;     // network order
};

}  // namespace surefoot
