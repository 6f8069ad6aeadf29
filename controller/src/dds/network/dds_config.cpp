// SPDX-License-Identifier: BSD-3-Clause
#include "dds/network/dds_config.hpp"

namespace surefoot {

// Settings of Cyclone DDS. On a loopback interface without the flag MULTICAST some versions use
// multicast and others do not, so peers must be found in both ways: multicast is set explicitly,
// and the ports of up to kMaxProcesses processes on this machine are tried too.
std::string dds_config(const NetworkInterface& interface) {
  constexpr const char* kMaxProcesses = "32";  // chosen; more than a robot and its programs have
  std::string discovery;
  if (interface.is_loopback) {
    discovery =
        std::string(
            "<Discovery><ParticipantIndex>auto</ParticipantIndex><MaxAutoParticipantIndex>") +
        kMaxProcesses +
        "</MaxAutoParticipantIndex><Peers><Peer address=\"localhost\"/></Peers></Discovery>";
  }
  return "<CycloneDDS><Domain Id=\"any\"><General><Interfaces><NetworkInterface name=\"" +
         interface.name + "\" multicast=\"true\"/></Interfaces></General>" + discovery +
         "</Domain></CycloneDDS>";
}

}  // namespace surefoot
