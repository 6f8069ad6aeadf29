// SPDX-License-Identifier: BSD-3-Clause
#include "dds/network/interface_check.hpp"

#include <ifaddrs.h>
#include <net/if.h>
#include <sys/socket.h>

#include <algorithm>
#include <vector>

#include "common/text.hpp"
#include "surefoot/error.hpp"

namespace surefoot {

namespace {

struct InterfaceState {
  std::string name;
  unsigned flags = 0;
  bool has_ipv4 = false;
};

std::vector<InterfaceState> interfaces() {
  std::vector<InterfaceState> found;
  ifaddrs* list = nullptr;
  if (getifaddrs(&list) != 0) return found;
  for (const ifaddrs* entry = list; entry != nullptr; entry = entry->ifa_next) {
    const auto same_name = [&](const InterfaceState& i) { return i.name == entry->ifa_name; };
    auto it = std::find_if(found.begin(), found.end(), same_name);
    if (it == found.end()) it = found.insert(it, {entry->ifa_name, entry->ifa_flags, false});
    it->has_ipv4 |= entry->ifa_addr != nullptr && entry->ifa_addr->sa_family == AF_INET;
  }
  freeifaddrs(list);
  return found;
}

std::string names_of(const std::vector<InterfaceState>& list) {
  std::vector<std::string> names;
  for (const InterfaceState& i : list) names.push_back(i.name);
  return join(names);
}

}  // namespace

NetworkInterface find_interface(const std::string& name) {
  const std::vector<InterfaceState> list = interfaces();
  const auto it = std::find_if(list.begin(), list.end(),
                               [&](const InterfaceState& i) { return i.name == name; });
  const std::string subject = "network interface '" + name + "': ";
  if (it == list.end()) {
    throw Error(subject + (name.empty() ? "got no name" : "got no such interface") +
                ", expected one of " + names_of(list));
  }
  if ((it->flags & IFF_UP) == 0)
    throw Error(subject + "it is down, expected one that is up; use: ip link set " + name + " up");
  if (!it->has_ipv4) {
    throw Error(subject + "it has no IPv4 address, expected one; use for a robot: ip addr add " +
                "192.168.123.222/24 dev " + name);
  }
  const bool is_loopback = (it->flags & IFF_LOOPBACK) != 0;
  const bool has_multicast = (it->flags & IFF_MULTICAST) != 0;
  if (!has_multicast && !is_loopback) {
    throw Error(subject + "its multicast is off, expected on, because DDS finds its peers by " +
                "multicast; use: ip link set " + name + " multicast on");
  }
  return {name, is_loopback, has_multicast};
}

}  // namespace surefoot
