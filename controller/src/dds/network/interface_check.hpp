// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace surefoot {

/// Network interface of this machine that can carry DDS.
struct NetworkInterface {
  std::string name;
  bool is_loopback = false;
  bool has_multicast_flag = false;  ///< false only for a loopback interface
};

/// Find a network interface. Real-time: no.
///
/// Throws surefoot::Error if the name is empty, if there is no interface with this name, if it is
/// down, has no IPv4 address, or if its multicast is off (loopback excepted); the message has the
/// remedy.
NetworkInterface find_interface(const std::string& name);

}  // namespace surefoot
