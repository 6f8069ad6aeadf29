// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "dds/network/discovery.hpp"

namespace surefoot {

/// What a program expects of the writers of a topic.
struct WriterRule {
  const char* topic;
  const char* type;         ///< name of the only right type
  std::size_t max_writers;  ///< most writers of this type, without that of this program
  /// What to do about too many writers, the end of a sentence.
  const char* remedy;
};

/// Watches the writers of some topics in a thread of its own, which reads them only after changes.
class PeerWatch {
 public:
  /// Wait for peers to be discovered, and check them. Throws surefoot::Error if discovery_time is
  /// out of range, if a writer has another type, or if there are too many writers. The program
  /// creates its own writer afterwards, so that a refused program does not disturb the others.
  /// @param discovery_time [s], 0 .. 60
  PeerWatch(const DdsParticipant& participant, std::vector<WriterRule> rules,
            double discovery_time);
  ~PeerWatch();
  PeerWatch(const PeerWatch&) = delete;
  PeerWatch& operator=(const PeerWatch&) = delete;

  /// Start the thread. @param own writer of this program, which no rule counts
  void start(const ddsc::Guid& own);
  /// Return whether a rule is broken at present, or the writers cannot be read. From any thread.
  /// Real-time: yes.
  bool conflict() const noexcept { return conflict_.load(); }
  /// Return whether the topic of a rule has too many writers of the right type at present. If the
  /// writers cannot be read, the last known answer holds. From any thread. Real-time: yes.
  bool crowded(std::size_t rule) const noexcept { return (crowded_.load() >> rule & 1U) != 0; }
  /// Return the handle of the only writer of the topic of a rule, see DiscoveredEndpoint::handle; 0
  /// if there is none or more than one. From any thread. Real-time: yes.
  std::uint64_t only_writer(std::size_t rule) const noexcept { return only_writer_[rule].load(); }
  /// Return the processes that write the topic of a rule, "none" if there is none. From any thread.
  std::string owners(std::size_t rule);
  /// Return sentences about writers that came or vanished since the last call. From any thread.
  std::vector<std::string> take_news();

 private:
  void check_at_start(double discovery_time);
  void run();
  bool look();
  struct Finding {
    bool crowded = false;  // too many writers of the right type
    std::string problem;   // "" if there is none
  };
  Finding look_at(std::size_t rule);
  Finding judge(const WriterRule& rule, const std::vector<DiscoveredEndpoint>& writers) const;
  void report_changes(std::size_t rule, const std::vector<DiscoveredEndpoint>& writers);

  DdsDiscovery discovery_;
  std::vector<WriterRule> rules_;
  ddsc::Guid own_{};  // writer of this program; all zero: none yet
  std::atomic<bool> conflict_{false};
  std::atomic<unsigned> crowded_{0};  // bit k: answer of crowded(k)
  std::vector<std::atomic<std::uint64_t>> only_writer_;
  std::mutex mutex_;  // guards the members below
  std::condition_variable stopped_;
  bool stop_ = false;
  std::vector<std::map<ddsc::Guid, std::string>> known_;  // writers by rule, with their owners
  std::vector<std::string> news_;
  std::thread thread_;
};

}  // namespace surefoot
