// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "dds/network/participant.hpp"

namespace surefoot {

/// Reader or writer that DDS has discovered, one of this process included.
struct DiscoveredEndpoint {
  ddsc::Guid guid;
  std::uint64_t handle;  ///< of a writer: SampleInfo::publication_handle of its samples
  std::string type;      ///< name of its type, such as "unitree_go::msg::dds_::LowCmd_"
  bool is_reliable;      ///< false: best effort
  std::string owner;     ///< its process, such as "process python3 (pid 4242) on robot"
};

/// Lists the endpoints that DDS has discovered. Not thread-safe. Real-time: no.
class DdsDiscovery {
 public:
  /// Create the readers of the built-in topics. Throws surefoot::Error if libddsc cannot.
  explicit DdsDiscovery(const DdsParticipant& participant);

  // Both throw surefoot::Error if libddsc cannot read them.
  std::vector<DiscoveredEndpoint> writers(const std::string& topic) const;  ///< writers of a topic
  std::vector<DiscoveredEndpoint> readers(const std::string& topic) const;  ///< readers of a topic
  /// Return whether a writer of any topic has come or gone since the last call; true at first.
  /// Real-time: yes.
  bool take_writer_changes() noexcept { return writers_changed_->exchange(false); }

 private:
  std::vector<DiscoveredEndpoint> endpoints(const DdsEntity& reader,
                                            const std::string& topic) const;
  std::map<ddsc::Guid, std::string> owners() const;
  std::string owner_text(const ddsc::ParticipantSample& participant) const;
  bool is_reliable(const ddsc::EndpointSample& endpoint) const;

  const ddsc::Functions& functions_;
  // On the heap: threads of libddsc write it. Declared before the reader, so deleted after it.
  std::unique_ptr<std::atomic<bool>> writers_changed_;
  DdsEntity participants_, writers_, readers_;
};

}  // namespace surefoot
