// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>

#include "dds/network/participant.hpp"

namespace surefoot {

/// Writer of a topic: reliable, newest sample only, as in unitree_sdk2.
class DdsWriter {
 public:
  /// Create the writer. Throws surefoot::Error if libddsc cannot create it.
  DdsWriter(const DdsParticipant& participant, const dds_topic_descriptor_t& type,
            const char* topic);

  /// Write a sample. A reliable reader that is slow blocks this call for at most 1 ms. Real-time:
  /// yes, except that libddsc may allocate and lock.
  /// @return 0, or a return code such as ddsc::kTimeout
  ddsc::Return write(const void* sample) noexcept {
    return functions_->write(writer_.handle(), sample);
  }
  /// Return the identifier that other participants see.
  const ddsc::Guid& guid() const noexcept { return guid_; }

 private:
  const ddsc::Functions* functions_;
  DdsEntity topic_, writer_;
  ddsc::Guid guid_{};
};

/// Reader of a topic: best effort, the newest samples.
class DdsReader {
 public:
  static constexpr int kDepth = 32;  ///< number of samples that the reader keeps

  /// Create the reader. Throws surefoot::Error if libddsc cannot create it.
  DdsReader(const DdsParticipant& participant, const dds_topic_descriptor_t& type,
            const char* topic);

  /// Take the oldest sample. Never blocks. Real-time: yes, except that libddsc may lock.
  /// @param sample struct of the type, without pointers
  /// @param writer receives the handle of the writer, see DiscoveredEndpoint::handle; or nullptr
  /// @return true if a sample was taken
  bool take(void* sample, std::uint64_t* writer = nullptr) noexcept;
  /// Return when the newest sample arrived [s], on monotonic_time(). Real-time: yes.
  double last_arrival() const noexcept { return last_arrival_->load(); }

  ddsc::Entity handle() const noexcept { return reader_.handle(); }
  const ddsc::Functions& functions() const noexcept { return *functions_; }

 private:
  const ddsc::Functions* functions_;
  // On the heap: a thread of libddsc writes it. Declared before the reader, so deleted after it.
  std::unique_ptr<std::atomic<double>> last_arrival_;
  DdsEntity topic_, reader_;
};

}  // namespace surefoot
