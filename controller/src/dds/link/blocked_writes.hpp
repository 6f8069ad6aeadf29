// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstdint>
#include <string>
#include <vector>

#include "dds/network/discovery.hpp"

namespace surefoot {

/// Reports writes that timed out, with the readers that can block a writer of the topic. DDS does
/// not tell which of them did.
class BlockedWrites {
 public:
  /// Throw surefoot::Error if libddsc cannot read the discovered readers.
  BlockedWrites(const DdsParticipant& participant, const char* topic);

  /// Note the result of a write. Real-time: yes.
  void on_write(ddsc::Return result) noexcept { count_ += result == ddsc::kTimeout ? 1U : 0U; }
  /// Return the number of writes that timed out. Real-time: yes.
  std::uint64_t count() const noexcept { return count_.load(); }
  /// Add a sentence if writes have timed out since the last one, at most one in 10 s. From any
  /// thread, one at a time. Real-time: no.
  void add_to(std::vector<std::string>& news);

 private:
  std::string readers() const;

  DdsDiscovery discovery_;
  const char* topic_;
  std::atomic<std::uint64_t> count_{0};
  std::uint64_t reported_ = 0;  // count_ at the last sentence
  double report_time_ = 0.0;    // [s] time of the last sentence
};

}  // namespace surefoot
