// SPDX-License-Identifier: BSD-3-Clause
#include "dds/link/peer_watch.hpp"

#include <chrono>
#include <utility>

#include "common/text.hpp"
#include "surefoot/error.hpp"

namespace surefoot {

namespace {

// Period of the thread. Chosen: a second commander is noticed after a few of its commands. If
// shorter: the thread takes more time from the control loop.
constexpr auto kPeriod = std::chrono::milliseconds(10);
// Number of periods after which the writers are read even without a change. Chosen: 5 s; only for a
// change that libddsc did not report.
constexpr int kMaxQuietPeriods = 500;
// Remedy for the writer of a killed process, which stays listed until its lease of 10 s ends. The
// check does not wait for that, because each refusal of a running program would take 10 s then.
constexpr const char* kLeaseRemedy =
    "; the writer of a process that was killed is still listed for up to 10 s: wait, then try "
    "again";
constexpr double kMaxDiscoveryTime = 60.0;  // [s] chosen
constexpr std::size_t kMaxNews = 64;        // chosen; bounds the memory if nobody takes them

}  // namespace

PeerWatch::PeerWatch(const DdsParticipant& participant, std::vector<WriterRule> rules,
                     double discovery_time)
    : discovery_(participant),
      rules_(std::move(rules)),
      only_writer_(rules_.size()),
      known_(rules_.size()) {
  check_at_start(discovery_time);
}

void PeerWatch::start(const ddsc::Guid& own) {
  own_ = own;
  thread_ = std::thread([this] { run(); });
}

PeerWatch::~PeerWatch() {
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  stopped_.notify_all();
  if (thread_.joinable()) thread_.join();
}

// Wait for the whole time even if no rule is broken: more peers may be discovered. Other writers
// may still be leaving, so only those that exist at the end count.
void PeerWatch::check_at_start(double discovery_time) {
  if (!(discovery_time >= 0.0 && discovery_time <= kMaxDiscoveryTime)) {
    throw Error("discovery_time: got " + to_text(discovery_time) + ", expected 0 .. " +
                to_text(kMaxDiscoveryTime) + " [s]");
  }
  std::this_thread::sleep_for(std::chrono::duration<double>(discovery_time));
  for (std::size_t k = 0; k < rules_.size(); ++k) {
    const std::string problem = look_at(k).problem;
    if (!problem.empty()) throw Error(problem);
  }
}

void PeerWatch::run() {
  std::unique_lock lock(mutex_);
  int quiet_periods = kMaxQuietPeriods;
  while (!stopped_.wait_for(lock, kPeriod, [this] { return stop_; })) {
    lock.unlock();
    const bool changed = discovery_.take_writer_changes();
    if (changed || ++quiet_periods >= kMaxQuietPeriods) {
      quiet_periods = look() ? 0 : kMaxQuietPeriods;
    }
    lock.lock();
  }
}

// Judge all rules; return false if the writers cannot be read. That counts as a conflict, because
// the writers are unknown.
bool PeerWatch::look() {
  bool conflict = false;
  unsigned crowded = 0;
  try {
    for (std::size_t k = 0; k < rules_.size(); ++k) {
      const Finding finding = look_at(k);
      conflict = !finding.problem.empty() || conflict;
      crowded |= (finding.crowded ? 1U : 0U) << k;
    }
  } catch (const Error&) {
    conflict_.store(true);
    return false;
  }
  crowded_.store(crowded);
  conflict_.store(conflict);
  return true;
}

// Read the writers of the topic of a rule, note them, and return what is wrong with them.
PeerWatch::Finding PeerWatch::look_at(std::size_t rule) {
  const std::vector<DiscoveredEndpoint> writers = discovery_.writers(rules_[rule].topic);
  report_changes(rule, writers);
  const bool is_only = writers.size() == 1 && writers[0].guid != own_;
  only_writer_[rule].store(is_only ? writers[0].handle : 0);
  return judge(rules_[rule], writers);
}

// Return what is wrong with the writers of a topic.
PeerWatch::Finding PeerWatch::judge(const WriterRule& rule,
                                    const std::vector<DiscoveredEndpoint>& writers) const {
  Finding finding;
  std::vector<std::string> owners;
  for (const DiscoveredEndpoint& writer : writers) {
    if (writer.guid == own_) continue;
    if (writer.type != rule.type) {
      finding.problem = std::string(rule.topic) + ": got a writer of type " + writer.type + " (" +
                        writer.owner + "), expected " + rule.type +
                        "; unitree_hg is the type of humanoids: choose another domain or interface";
      continue;
    }
    owners.push_back(writer.owner);
  }
  finding.crowded = owners.size() > rule.max_writers;
  if (finding.crowded && finding.problem.empty()) {
    finding.problem = std::string(rule.topic) + ": got " + std::to_string(owners.size()) +
                      " other writer(s) (" + join(owners) + "), expected " +
                      std::to_string(rule.max_writers) + "; " + rule.remedy + kLeaseRemedy;
  }
  return finding;
}

void PeerWatch::report_changes(std::size_t rule, const std::vector<DiscoveredEndpoint>& writers) {
  std::map<ddsc::Guid, std::string> present;
  for (const DiscoveredEndpoint& writer : writers) {
    if (writer.guid != own_) present[writer.guid] = writer.owner;
  }
  const std::string topic = rules_[rule].topic;
  const std::lock_guard lock(mutex_);
  const auto add = [this](std::string line) {
    if (news_.size() < kMaxNews) news_.push_back(std::move(line));
  };
  for (const auto& [guid, owner] : present) {
    if (known_[rule].count(guid) == 0) add("writer of " + topic + " found: " + owner);
  }
  for (const auto& [guid, owner] : known_[rule]) {
    if (present.count(guid) == 0) add("writer of " + topic + " has gone: " + owner);
  }
  known_[rule] = std::move(present);
}

std::string PeerWatch::owners(std::size_t rule) {
  const std::lock_guard lock(mutex_);
  std::vector<std::string> owners;
  for (const auto& [guid, owner] : known_[rule]) owners.push_back(owner);
  return owners.empty() ? "none" : join(owners);
}

std::vector<std::string> PeerWatch::take_news() {
  const std::lock_guard lock(mutex_);
  return std::exchange(news_, {});
}

}  // namespace surefoot
