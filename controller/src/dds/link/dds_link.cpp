// SPDX-License-Identifier: BSD-3-Clause
#include "surefoot/dds_link.hpp"

#include <algorithm>
#include <cstring>
#include <limits>

#include "common/clock.hpp"
#include "common/text.hpp"
#include "dds/link/arrival_tick.hpp"
#include "dds/link/peer_watch.hpp"
#include "dds/link/topics.hpp"
#include "dds/network/endpoints.hpp"
#include "dds/wire/low_cmd_conversion.hpp"
#include "dds/wire/low_state_conversion.hpp"
#include "link/state_intake.hpp"
#include "surefoot/error.hpp"

namespace surefoot {

namespace {

// [N.m.s/rad] Range of DdsLinkOptions::damping_kd, equal to the range of Gains::damping_kd.
constexpr double kMinKd = 0.0625, kMaxKd = 50.0;
constexpr double kMaxDiscoveryTime = 60.0;  // [s] chosen
// Number of LowStates with tick 0 that show that the tick stands still. Chosen: 0.1 s at 500 Hz.
constexpr std::uint64_t kStandingTicks = 50;
// [s] Silence that take_news() reports. Equal to kRobotWatchdogTime. DDS itself notices a process
// that has crashed only after 10 s.
constexpr double kReportedSilence = 0.1;
// Positions of the rules of kCommandTopic and kStateTopic in link_rules().
constexpr std::size_t kCommandRule = 0, kStateRule = 1;
// Number of damping commands that follow the last command of the caller, before the link is silent
// beside another commander. Chosen: 20 ms at 500 Hz; one or two may be lost. If larger: both
// programs alternate on the motors for longer.
constexpr int kLastDampings = 10;
// [s] Time for which a LowState of a second robot is a conflict. Chosen: longer than PeerWatch
// needs to find the writer of that robot.
constexpr double kSecondRobotTime = 0.2;

const DdsLinkOptions& checked(const DdsLinkOptions& options) {
  const auto check = [](const char* name, double got, double lower, double upper,
                        const char* unit) {
    if (got >= lower && got <= upper) return;
    throw Error(std::string(name) + ": got " + to_text(got) + ", expected " + to_text(lower) +
                " .. " + to_text(upper) + unit);
  };
  check("damping_kd", options.damping_kd, kMinKd, kMaxKd, " [N.m.s/rad]");
  check("discovery_time", options.discovery_time, 0.0, kMaxDiscoveryTime, " [s]");
  return options;
}

std::vector<WriterRule> link_rules() {
  return {{kCommandTopic, unitree_go_msg_dds__LowCmd__desc.m_typename, 0,
           "end the other program, or release the sport service, so that only one commands"},
          {kStateTopic, unitree_go_msg_dds__LowState__desc.m_typename, 1,
           "end one of the robots, or choose another domain or interface"}};
}

}  // namespace

struct DdsLink::Impl {
  Impl(std::shared_ptr<DdsNetwork> n, const DdsLinkOptions& o)
      : options(checked(o)),
        network(std::move(n)),
        reader(participant_of(network), unitree_go_msg_dds__LowState__desc, kStateTopic),
        peers(network->participant(), link_rules(), o.discovery_time),
        writer(network->participant(), unitree_go_msg_dds__LowCmd__desc, kCommandTopic) {
    peers.start(writer.guid());
    to_dds(damping_low_cmd(o.damping_kd), o.robot, o.damping_kd, damping);
    std::memset(&sample, 0, sizeof(sample));
  }
  bool is_from_robot(std::uint64_t writer, double time) noexcept;
  bool process_sample(double time) noexcept;
  bool in_conflict(double time) const noexcept {
    return peers.conflict() || time - second_robot_time < kSecondRobotTime;
  }
  const DdsLowCmd* choose(bool usable) noexcept;
  void add_silence(std::vector<std::string>& news);

  DdsLinkOptions options;
  std::shared_ptr<DdsNetwork> network;
  DdsReader reader;
  PeerWatch peers;
  DdsWriter writer;
  DdsLowCmd command, damping;
  int dampings_left = 0;  // damping commands that may still be sent beside another commander
  DdsLowState sample;
  LowState incoming = init_low_state();
  ArrivalTick arrival_tick;
  StateIntake intake;
  DdsCounts counts;
  // [s] Time of the last receive() that found no sample, on monotonic_time().
  double last_empty_time = 0.0;
  std::uint64_t robot_writer = 0;  // writer of the first valid LowState; 0: none yet
  // [s] Arrival of the last LowState of a second robot.
  double second_robot_time = -std::numeric_limits<double>::infinity();
  // Published for take_news(), which other threads call.
  std::atomic<bool> crc_missing{false}, head_missing{false}, tick_stands{false};
  bool crc_reported = false, head_reported = false, tick_reported = false;
  bool silence_reported = false;
};

DdsLink::DdsLink(std::shared_ptr<DdsNetwork> network, const DdsLinkOptions& options)
    : impl_(std::make_unique<Impl>(std::move(network), options)) {}
DdsLink::~DdsLink() = default;

bool DdsLink::receive() noexcept {
  Impl& s = *impl_;
  s.intake.status.conflict = s.in_conflict(monotonic_time());
  bool newer = false;
  for (int k = 0; k < kMaxSamplesPerReceive; ++k) {
    const double start = monotonic_time();
    std::uint64_t writer = 0;
    if (!s.reader.take(&s.sample, &writer)) {
      s.last_empty_time = start;
      return newer;
    }
    // The stamp belongs to the newest sample, and may be one sample late.
    const double now = monotonic_time();
    const double arrival = std::clamp(s.reader.last_arrival(), s.last_empty_time, now);
    if (!s.is_from_robot(writer, now)) continue;
    const std::uint64_t valid = s.intake.status.counts.valid;
    newer = s.process_sample(arrival) || newer;
    if (s.intake.status.counts.valid > valid) s.robot_writer = writer;
  }
  ++s.intake.status.counts.floods;
  return newer;
}

// Return whether a sample comes from the writer whose LowStates are used. If another writer is the
// only one left, the robot has restarted. Otherwise the sample is one of a second robot: a
// conflict.
bool DdsLink::Impl::is_from_robot(std::uint64_t writer, double time) noexcept {
  if (robot_writer == 0 || writer == robot_writer) return true;
  if (peers.only_writer(kStateRule) == writer) {
    robot_writer = 0;  // the next valid LowState decides
    intake.restart();
    return true;
  }
  ++counts.second_robot;
  second_robot_time = time;
  intake.status.conflict = true;
  return false;
}

// Convert and count a sample, and store its LowState if it is newer than the stored one. Return
// whether it was stored.
// @param time arrival time [s], on monotonic_time()
bool DdsLink::Impl::process_sample(double time) noexcept {
  ++intake.status.counts.received;
  const FrameReport report = from_dds(sample, options.robot, options.crc, incoming);
  if (report.status != FrameStatus::kOk) {
    intake.reject(report);
    return false;
  }
  counts.without_crc += sample.crc == 0;
  counts.without_head += !has_head(sample);
  counts.without_tick += sample.tick == 0;
  crc_missing.store(counts.without_crc > 0);
  head_missing.store(counts.without_head > 0);
  tick_stands.store(counts.without_tick >= kStandingTicks);
  const bool tick_from_arrival = options.tick == TickSource::kArrival && incoming.tick == 0;
  if (tick_from_arrival) incoming.tick = arrival_tick.next(time);
  return intake.accept(incoming, time, !tick_from_arrival);
}

FrameReport DdsLink::send(const LowCmd& cmd) noexcept {
  Impl& s = *impl_;
  const FrameReport report = to_dds(cmd, s.options.robot, s.options.damping_kd, s.command);
  const bool usable = is_usable(report.status);
  if (!usable) ++s.intake.status.counts.refused;
  const DdsLowCmd* const outgoing = s.choose(usable);
  if (outgoing == nullptr) return report;
  const ddsc::Return result = s.writer.write(outgoing);
  if (result == ddsc::kTimeout) ++s.counts.timeouts;
  ++(result == 0 ? s.intake.status.counts.sent : s.intake.status.counts.send_failed);
  return report;
}

// Return what to write: `command`, `damping`, or nullptr for nothing. See the comment of DdsLink.
// @param usable whether `command` is finite
const DdsLowCmd* DdsLink::Impl::choose(bool usable) noexcept {
  intake.status.conflict = in_conflict(monotonic_time());
  if (!intake.status.conflict) {
    if (!usable || !intake.status.has_state) return &damping;
    dampings_left = kLastDampings;
    return &command;
  }
  ++counts.conflicts;
  if (!peers.crowded(kCommandRule)) return &damping;
  if (dampings_left > 0) {
    --dampings_left;
    return &damping;
  }
  ++counts.withheld;
  return nullptr;
}

const LinkStatus& DdsLink::status() const noexcept { return impl_->intake.status; }
bool DdsLink::allows_real_robot() const noexcept { return impl_->network->options().real_robot; }
const DdsCounts& DdsLink::dds_counts() const noexcept { return impl_->counts; }

void DdsLink::Impl::add_silence(std::vector<std::string>& news) {
  const double last_arrival = reader.last_arrival();
  const bool silent = last_arrival > 0.0 && monotonic_time() - last_arrival > kReportedSilence;
  if (silent == silence_reported) return;
  silence_reported = silent;
  const std::string robot = peers.owners(kStateRule);
  news.push_back(silent ? "no LowState for " + to_text(kReportedSilence) + " s from " + robot
                        : "LowStates are back from " + robot);
}

std::vector<std::string> DdsLink::take_news() {
  Impl& s = *impl_;
  std::vector<std::string> news = s.peers.take_news();
  s.add_silence(news);
  if (s.crc_missing.load() && !s.crc_reported) {
    s.crc_reported = true;
    news.emplace_back("LowStates carry crc 0: their CRC is not checked");
  }
  if (s.head_missing.load() && !s.head_reported) {
    s.head_reported = true;
    news.emplace_back("LowStates have no head, as from unitree_mujoco: servo mode is assumed");
  }
  if (s.tick_stands.load() && !s.tick_reported) {
    s.tick_reported = true;
    news.emplace_back(s.options.tick == TickSource::kArrival
                          ? "the tick of the LowStates stands at 0: the tick is made from arrival"
                          : "the tick of the LowStates stands at 0, so none is new; use --tick "
                            "arrival (TickSource::kArrival)");
  }
  return news;
}

}  // namespace surefoot
