// SPDX-License-Identifier: BSD-3-Clause
#include "link/udp_socket.hpp"

#include <arpa/inet.h>
#include <netdb.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "common/clock.hpp"
#include "surefoot/error.hpp"

namespace surefoot {

namespace {

// [bytes] Size of the receive buffer. Chosen: room for about 100 frames. When the buffer is full,
// the system drops new datagrams and keeps the old datagrams. So after a stall the process reads
// old samples first; stamped_age() gives their age.
constexpr int kReceiveBuffer = 128 * 1024;

// Return the age [s] of a datagram: the time on the wall clock since the system stamped its
// arrival. Return 0 for a datagram without a stamp.
double stamped_age(msghdr& message) noexcept {
  for (cmsghdr* c = CMSG_FIRSTHDR(&message); c != nullptr; c = CMSG_NXTHDR(&message, c)) {
    if (c->cmsg_level != SOL_SOCKET || c->cmsg_type != SCM_TIMESTAMPNS) continue;
    timespec stamp, wall;
    std::memcpy(&stamp, CMSG_DATA(c), sizeof(stamp));
    clock_gettime(CLOCK_REALTIME, &wall);
    return static_cast<double>(wall.tv_sec - stamp.tv_sec) +
           1e-9 * static_cast<double>(wall.tv_nsec - stamp.tv_nsec);
  }
  return 0.0;
}

void check_port(const char* what, int port, int min_port) {
  if (port < min_port || port > 65535) {
    throw Error(std::string(what) + ": got " + std::to_string(port) + ", expected " +
                std::to_string(min_port) + " .. 65535");
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
                "; expected an IPv4 address such as 127.0.0.1, or a name that resolves to one");
  }
  const in_addr address = reinterpret_cast<const sockaddr_in*>(found->ai_addr)->sin_addr;
  freeaddrinfo(found);
  return address;
}

// Return whether an address is a loopback address, 127.x.x.x.
bool is_loopback(const in_addr& address) { return (ntohl(address.s_addr) >> 24) == 127; }

}  // namespace

double arrival_time(double now, double age, double last_empty) noexcept {
  return std::clamp(now - age, std::min(last_empty, now), now);
}

UdpSocket::UdpSocket(const std::string& host, int port, int local_port, bool allow_remote_peer) {
  check_port("port", port, 1);
  check_port("local port", local_port, 0);
  const in_addr address = resolve(host);
  const bool loopback = is_loopback(address);
  if (!loopback && !allow_remote_peer) {
    throw Error(
        "host '" + host +
        "': got a peer beyond this machine, expected 127.x.x.x; for a real robot with arming "
        "checks use: surefoot run --rise --real-robot");
  }
  peer_address_ = address.s_addr;
  peer_port_ = htons(static_cast<std::uint16_t>(port));
  fd_ = socket(AF_INET, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
  if (fd_ < 0) throw Error(std::string("UDP socket: ") + std::strerror(errno));
  setsockopt(fd_, SOL_SOCKET, SO_RCVBUF, &kReceiveBuffer, sizeof(kReceiveBuffer));
  const int on = 1;
  setsockopt(fd_, SOL_SOCKET, SO_TIMESTAMPNS, &on, sizeof(on));
  sockaddr_in local{};
  local.sin_family = AF_INET;
  local.sin_addr.s_addr = htonl(loopback ? INADDR_LOOPBACK : INADDR_ANY);
  local.sin_port = htons(static_cast<std::uint16_t>(local_port));
  if (bind(fd_, reinterpret_cast<const sockaddr*>(&local), sizeof(local)) != 0) {
    const std::string why = std::strerror(errno);
    close(fd_);
    throw Error("local port " + std::to_string(local_port) + ": " + why +
                "; use another port, or 0 for any free one");
  }
  socklen_t size = sizeof(local);
  getsockname(fd_, reinterpret_cast<sockaddr*>(&local), &size);
  local_port_ = ntohs(local.sin_port);
}

UdpSocket::~UdpSocket() {
  if (fd_ >= 0) close(fd_);
}

UdpSocket::ReadResult UdpSocket::read(std::uint8_t* data, std::size_t& size,
                                      double& arrival_stamp) noexcept {
  sockaddr_in from{};
  iovec buffer{data, size};
  alignas(cmsghdr) char control[CMSG_SPACE(sizeof(timespec))];
  msghdr message{};
  message.msg_name = &from;
  message.msg_namelen = sizeof(from);
  message.msg_iov = &buffer;
  message.msg_iovlen = 1;
  message.msg_control = control;
  message.msg_controllen = sizeof(control);
  const double read_start = monotonic_time();
  const ssize_t got = recvmsg(fd_, &message, MSG_DONTWAIT | MSG_TRUNC);
  if (got < 0) {
    last_empty_time_ = read_start;
    return ReadResult::kNothing;
  }
  size = static_cast<std::size_t>(got);
  arrival_stamp = arrival_time(monotonic_time(), stamped_age(message), last_empty_time_);
  const bool from_peer = from.sin_addr.s_addr == peer_address_ && from.sin_port == peer_port_;
  return from_peer ? ReadResult::kPeer : ReadResult::kOtherSender;
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
