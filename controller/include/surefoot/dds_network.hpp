// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

namespace surefoot {

class DdsParticipant;

/// Options of a DdsNetwork.
struct DdsNetworkOptions {
  std::string interface;          ///< name of the network interface, such as "lo" or "enp3s0"
  int domain = 0;                 ///< DDS domain, 0 .. 230; robots: 0, unitree_mujoco: 1
  bool real_robot = false;        ///< true: any interface is allowed; false: only loopback
  std::string library;            ///< file of libddsc; "": the package cyclonedds, else the system
  bool untested_library = false;  ///< true: a version of libddsc that was not tested is allowed
};

/// Membership of this process in a DDS domain on one network interface.
///
/// Loads libddsc, the C library of Cyclone DDS, at run time. The settings of Cyclone DDS are its
/// own: CYCLONEDDS_URI is not used. The participant sends no type information, because Cyclone DDS
/// 0.10.2, which robots run, crashes on that of newer versions. Not thread-safe.
class DdsNetwork {
 public:
  /// Join the domain. Throws surefoot::Error if the interface does not exist, is down, has no IPv4
  /// address or no multicast, if it is not loopback and real_robot is false, if libddsc is missing
  /// or of an untested version, or if this process is already in the domain.
  explicit DdsNetwork(const DdsNetworkOptions& options);
  ~DdsNetwork();
  DdsNetwork(const DdsNetwork&) = delete;
  DdsNetwork& operator=(const DdsNetwork&) = delete;

  /// Return sentences about the settings for the operator, such as the version of libddsc.
  const std::vector<std::string>& notices() const noexcept;
  const DdsNetworkOptions& options() const noexcept;  ///< options of the constructor
  /// Return the participant, for the classes that send and receive in this domain.
  const DdsParticipant& participant() const noexcept;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace surefoot
