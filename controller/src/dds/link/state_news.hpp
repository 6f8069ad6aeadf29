// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <string>
#include <vector>

#include "surefoot/dds_link.hpp"

namespace surefoot {

/// Collects what a DdsLink reports to the operator about its LowStates.
class StateNews {
 public:
  explicit StateNews(TickSource tick) : tick_(tick) {}

  // For the thread of DdsLink::receive(). Real-time: yes.
  /// Note a valid LowState. @param arrival [s], on monotonic_time()
  void on_valid(const DdsCounts& counts, double arrival) noexcept;
  /// Note that a LowState of a second robot was not used. @param count number of them so far
  void on_second_robot(std::uint64_t count) noexcept;
  /// Note the end of a receive() that began at a time [s].
  void on_receive(double time) noexcept { last_receive_.store(time); }

  /// Add sentences about what has changed since the last call. From any thread, one at a time.
  /// Real-time: no.
  /// @param robot processes that write rt/lowstate
  void add_to(std::vector<std::string>& news, const std::string& robot);

 private:
  void add_silence(std::vector<std::string>& news, const std::string& robot);

  TickSource tick_;
  std::atomic<double> last_receive_{0.0}, last_valid_{0.0};  // [s] 0: none yet
  std::atomic<bool> crc_missing_{false}, head_missing_{false}, tick_stands_{false},
      second_robot_{false};
  bool silence_reported_ = false, crc_reported_ = false, head_reported_ = false,
       tick_reported_ = false, second_robot_reported_ = false;
};

}  // namespace surefoot
