// SPDX-License-Identifier: BSD-3-Clause
// Interfaces that are down, or have no address or no multicast, in a network namespace of their
// own.
#include <linux/sockios.h>
#include <net/if.h>
#include <netinet/in.h>
#include <sched.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <boost/test/unit_test.hpp>
#include <cstring>
#include <functional>
#include <thread>

#include "dds/network/interface_check.hpp"
#include "surefoot/error.hpp"

using namespace surefoot;

namespace {

constexpr const char* kBridge = "sftest0";

// Changes interfaces of the network namespace in which it is made.
class Interfaces {
 public:
  Interfaces() : socket_(socket(AF_INET, SOCK_DGRAM, 0)) {}
  ~Interfaces() { close(socket_); }
  Interfaces(const Interfaces&) = delete;
  Interfaces& operator=(const Interfaces&) = delete;

  bool add_bridge() const { return ioctl(socket_, SIOCBRADDBR, kBridge) == 0; }
  void set_flag(const char* name, int flag, bool on) const {
    ifreq request = request_for(name);
    ioctl(socket_, SIOCGIFFLAGS, &request);
    const int flags = on ? request.ifr_flags | flag : request.ifr_flags & ~flag;
    request.ifr_flags = static_cast<short>(flags);
    ioctl(socket_, SIOCSIFFLAGS, &request);
  }
  void set_address(const char* name) const {
    ifreq request = request_for(name);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(0xC0A87BDE);  // 192.168.123.222
    std::memcpy(&request.ifr_addr, &address, sizeof(address));
    ioctl(socket_, SIOCSIFADDR, &request);
  }

 private:
  static ifreq request_for(const char* name) {
    ifreq request{};
    std::strncpy(request.ifr_name, name, IFNAMSIZ - 1);
    return request;
  }
  int socket_;
};

// Call a function in a network namespace that ends with it: only its thread is there. At first the
// namespace has the interface lo, which is down. Return false if it cannot be made.
bool in_namespace(const std::function<void(const Interfaces&)>& use) {
  bool made = false;
  std::thread([&] {
    made = unshare(CLONE_NEWNET) == 0;
    if (made) use(Interfaces());
  }).join();
  return made;
}

boost::test_tools::assertion_result can_make_interfaces(boost::unit_test::test_unit_id) {
  bool has_bridge = false;
  in_namespace([&](const Interfaces& interfaces) { has_bridge = interfaces.add_bridge(); });
  boost::test_tools::assertion_result result(has_bridge);
  result.message() << "no right to make a network namespace with a bridge: needs CAP_SYS_ADMIN";
  return result;
}

// Return the message of find_interface(); "" if it finds the interface.
std::string problem_of(const char* name) {
  try {
    find_interface(name);
    return "";
  } catch (const Error& error) {
    return error.what();
  }
}

}  // namespace

BOOST_AUTO_TEST_SUITE(interface_check, *boost::unit_test::precondition(can_make_interfaces))

BOOST_AUTO_TEST_CASE(interface_that_is_down_is_refused_with_the_remedy) {
  std::string down, up;
  in_namespace([&](const Interfaces& interfaces) {
    down = problem_of("lo");
    interfaces.set_flag("lo", IFF_UP, true);
    up = problem_of("lo");
  });
  BOOST_TEST(down ==
             "network interface 'lo': it is down, expected one that is up; use: ip link set lo up");
  BOOST_TEST(up == "");
}

BOOST_AUTO_TEST_CASE(interface_without_an_address_or_multicast_is_refused_with_the_remedy) {
  std::string no_address, no_multicast, usable;
  in_namespace([&](const Interfaces& interfaces) {
    interfaces.add_bridge();
    interfaces.set_flag(kBridge, IFF_UP, true);
    no_address = problem_of(kBridge);
    interfaces.set_address(kBridge);
    usable = problem_of(kBridge);
    interfaces.set_flag(kBridge, IFF_MULTICAST, false);
    no_multicast = problem_of(kBridge);
  });
  BOOST_TEST(no_address.find("it has no IPv4 address, expected one; use for a robot: ip addr add "
                             "192.168.123.222/24 dev sftest0") != std::string::npos);
  BOOST_TEST(usable == "");
  BOOST_TEST(no_multicast.find("its multicast is off, expected on") != std::string::npos);
  BOOST_TEST(no_multicast.find("use: ip link set sftest0 multicast on") != std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()
