// SPDX-License-Identifier: BSD-3-Clause
#include "dds/link/blocked_writes.hpp"

#include "common/clock.hpp"
#include "common/text.hpp"
#include "surefoot/error.hpp"

namespace surefoot {

namespace {
constexpr double kReportPeriod = 10.0;  // [s] chosen; a slow reader may block every write
}

BlockedWrites::BlockedWrites(const DdsParticipant& participant, const char* topic)
    : discovery_(participant), topic_(topic) {}

// Return the processes with a reliable reader of the topic: only such a reader blocks a writer.
std::string BlockedWrites::readers() const {
  std::vector<std::string> owners;
  try {
    for (const DiscoveredEndpoint& reader : discovery_.readers(topic_)) {
      if (reader.is_reliable) owners.push_back(reader.owner);
    }
  } catch (const Error&) {
    return "unknown, because libddsc cannot read them";
  }
  return owners.empty() ? "none at present" : join(owners);
}

void BlockedWrites::add_to(std::vector<std::string>& news) {
  const std::uint64_t count = count_.load();
  const double now = monotonic_time();
  if (count == reported_ || (reported_ > 0 && now - report_time_ < kReportPeriod)) return;
  news.push_back(std::string(topic_) + ": " + std::to_string(count - reported_) +
                 " message(s) timed out after 1 ms, because a reliable reader is slow; reliable "
                 "readers: " +
                 readers() + "; end the slow one, or make it best effort");
  reported_ = count;
  report_time_ = now;
}

}  // namespace surefoot
