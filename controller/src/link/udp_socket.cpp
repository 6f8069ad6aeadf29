// SPDX-License-Identifier: BSD-3-Clause
#include "link/udp_socket.hpp"

#include <arpa/inet.h>
#include <netdb.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "surefoot/error.hpp"

namespace surefoot {

namespace {

// Small, so that a stalled program finds what is new and not seconds of what was.
constexpr int kReceiveBuffer = 128 * 1024;

void check_port(const char* what, int port, int least) {
  if (port < least || port > 65535) {
    throw Error(std::string(what) + ": got " + std::to_string(port) + ", expected " +
                std::to_string(least) + " .. 65535");
  }
}

in_addr resolve(const std::string& host) {
  addrinfo hints{};
  hints.ai_family = AF_INET;
  hints.ai_socktype = SOCK_DGRAM;
  addrinfo* found = nullptr;
  const int problem = getaddrinfo(host.c_str(), nullptr, &hints, &found);
  if (problem != 0 || found == nullptr) {
    throw Error("host '" + host + "': " + gai_strerror(problem) +
                "; expected an IPv4 address such as 127.0.0.1, or a name that has one");
  }
  const in_addr address = reinterpret_cast<const sockaddr_in*>(found->ai_addr)->sin_addr;
  freeaddrinfo(found);
  return address;
}

// The first byte of an address on this machine's loopback.
bool is_loopback(const in_addr& address) { return (ntohl(address.s_addr) >> 24) == 127; }

}  // namespace

UdpSocket::UdpSocket(const std::string& host, int port, int local_port) {
  check_port("port", port, 1);
  check_port("local port", local_port, 0);
  const in_addr address = resolve(host);
  if (!is_loopback(address)) {
    throw Error("host '" + host +
                "': got a peer beyond this machine, expected 127.x.x.x; robots are "
                "talked to when there is arming");
  }
  peer_address_ = address.s_addr;
  peer_port_ = htons(static_cast<std::uint16_t>(port));
  fd_ = socket(AF_INET, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
  if (fd_ < 0) throw Error(std::string("UDP socket: ") + std::strerror(errno));
  setsockopt(fd_, SOL_SOCKET, SO_RCVBUF, &kReceiveBuffer, sizeof(kReceiveBuffer));
  sockaddr_in local{};
  local.sin_family = AF_INET;
  local.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  local.sin_port = htons(static_cast<std::uint16_t>(local_port));
  if (bind(fd_, reinterpret_cast<const sockaddr*>(&local), sizeof(local)) != 0) {
    const std::string why = std::strerror(errno);
    close(fd_);
    throw Error("local port " + std::to_string(local_port) + ": " + why +
                "; take another, or 0 for any");
  }
  socklen_t size = sizeof(local);
  getsockname(fd_, reinterpret_cast<sockaddr*>(&local), &size);
  local_port_ = ntohs(local.sin_port);
}

UdpSocket::~UdpSocket() {
  if (fd_ >= 0) close(fd_);
}

UdpSocket::Read UdpSocket::read(std::uint8_t* data, std::size_t& size) noexcept {
  sockaddr_in from{};
  socklen_t from_size = sizeof(from);
  const ssize_t got = recvfrom(fd_, data, size, MSG_DONTWAIT | MSG_TRUNC,
                               reinterpret_cast<sockaddr*>(&from), &from_size);
  if (got < 0) return Read::kNothing;
  size = static_cast<std::size_t>(got);
  const bool peer = from.sin_addr.s_addr == peer_address_ && from.sin_port == peer_port_;
  return peer ? Read::kPeer : Read::kStranger;
}

bool UdpSocket::write(const std::uint8_t* data, std::size_t size) noexcept {
  sockaddr_in to{};
  to.sin_family = AF_INET;
  to.sin_addr.s_addr = peer_address_;
  to.sin_port = peer_port_;
  const ssize_t sent = sendto(fd_, data, size, MSG_DONTWAIT | MSG_NOSIGNAL,
                              reinterpret_cast<const sockaddr*>(&to), sizeof(to));
  return sent == static_cast<ssize_t>(size);
}

}  // namespace surefoot
