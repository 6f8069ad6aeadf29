// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace surefoot {

/// Return the arrival time [s] of a datagram, on monotonic_time(), computed from its age:
///   clamp(now - age, last_empty, now)
/// The bounds are needed because the age is measured on the wall clock, which may jump. Real-time:
/// yes.
/// @param now present time [s], on monotonic_time()
/// @param age age of the datagram, from its stamp [s]
/// @param last_empty time of the last read that found no datagram [s], on monotonic_time()
double arrival_time(double now, double age, double last_empty) noexcept;

/// Non-blocking IPv4 UDP socket for one peer. Real-time: read() and write() yes.
class UdpSocket {
 public:
  /// Open the socket. Throw surefoot::Error if the host is unknown or not permitted, or if a port
  /// is out of range or cannot be bound.
  /// @param allow_remote_peer true: the peer may be on another machine
  UdpSocket(const std::string& host, int port, int local_port, bool allow_remote_peer);
  ~UdpSocket();
  UdpSocket(const UdpSocket&) = delete;
  UdpSocket& operator=(const UdpSocket&) = delete;

  /// kNothing: no datagram was waiting. kPeer, kOtherSender: the sender of the datagram.
  enum class ReadResult { kNothing, kPeer, kOtherSender };
  /// Read one datagram. Never blocks.
  /// @param size in: size of the buffer; out: length of the datagram, which may exceed the buffer
  /// @param arrival_stamp out: arrival time of the datagram at this machine [s], on
  /// monotonic_time()
  ReadResult read(std::uint8_t* data, std::size_t& size, double& arrival_stamp) noexcept;

  /// Send a datagram to the peer. Return false if the system did not accept it. Never blocks.
  bool write(const std::uint8_t* data, std::size_t size) noexcept;

  int local_port() const noexcept { return local_port_; }

 private:
  int fd_ = -1;
  // [s] Time of the last read that found no datagram, on monotonic_time().
  double last_empty_time_ = 0.0;
  int local_port_ = 0;
  std::uint32_t peer_address_ = 0;  // network byte order
  std::uint16_t peer_port_ = 0;     // network byte order
};

}  // namespace surefoot
