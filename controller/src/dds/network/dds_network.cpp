// SPDX-License-Identifier: BSD-3-Clause
#include "surefoot/dds_network.hpp"

#include <cstdlib>

#include "dds/ddsc/library_version.hpp"
#include "dds/ddsc/loaded_libraries.hpp"
#include "dds/network/dds_config.hpp"
#include "dds/network/participant.hpp"
#include "surefoot/error.hpp"

namespace surefoot {

namespace {

constexpr int kMaxDomain = 230;  // the UDP ports of higher domains would be above 65535

const DdsNetworkOptions& checked(const DdsNetworkOptions& options) {
  if (options.domain < 0 || options.domain > kMaxDomain) {
    throw Error("DDS domain: got " + std::to_string(options.domain) +
                ", expected 0 .. 230 (robots: 0, unitree_mujoco: 1)");
  }
  return options;
}

NetworkInterface allowed_interface(const DdsNetworkOptions& options) {
  const NetworkInterface interface = find_interface(options.interface);
  if (!interface.is_loopback && !options.real_robot) {
    throw Error("network interface '" + options.interface +
                "': got one that leads beyond this machine, expected lo; for a real robot with "
                "arming checks use: surefoot run --rise --real-robot");
  }
  return interface;
}

// Refuse a domain that this process has joined, even with another libddsc: the program that joined
// it may not expect a second participant.
const NetworkInterface& in_new_domain(const NetworkInterface& interface, int domain) {
  const std::string library = library_in_domain(domain);
  if (library.empty()) return interface;
  throw Error(
      "DDS domain " + std::to_string(domain) +
      ": got a domain that this process has joined already with " + library +
      ", as rclpy or cyclonedds do; expected a new one; join it in a process of its own, or "
      "use another domain");
}

}  // namespace

struct DdsNetwork::Impl {
  explicit Impl(const DdsNetworkOptions& o)
      : options(checked(o)),
        interface(allowed_interface(o)),
        participant(load_dds_library(o.library, o.untested_library), o.domain,
                    dds_config(in_new_domain(interface, o.domain))) {
    const DdsLibrary& library = participant.library();
    notices.push_back("DDS domain " + std::to_string(o.domain) + " on " + o.interface +
                      ", libddsc " + library.version + " (" + library.path + ")");
    if (!is_tested_library_version(library.version)) {
      notices.push_back("libddsc " + library.version + " was not tested, expected " +
                        tested_library_versions() + ": run simulations first");
    }
    if (std::getenv("CYCLONEDDS_URI") != nullptr) {
      notices.push_back("CYCLONEDDS_URI is set, but not used: the settings are interface " +
                        o.interface + " and domain " + std::to_string(o.domain));
    }
  }

  DdsNetworkOptions options;
  NetworkInterface interface;
  DdsParticipant participant;
  std::vector<std::string> notices;
};

DdsNetwork::DdsNetwork(const DdsNetworkOptions& options) : impl_(std::make_unique<Impl>(options)) {}
DdsNetwork::~DdsNetwork() = default;

const std::vector<std::string>& DdsNetwork::notices() const noexcept { return impl_->notices; }
const DdsNetworkOptions& DdsNetwork::options() const noexcept { return impl_->options; }
const DdsParticipant& DdsNetwork::participant() const noexcept { return impl_->participant; }

}  // namespace surefoot
