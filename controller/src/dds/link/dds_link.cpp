// SPDX-License-Identifier: BSD-3-Clause
#include "surefoot/dds_link.hpp"

#include <algorithm>
#include <cstring>
#include <limits>

#include "common/clock.hpp"
#include "common/text.hpp"
#include "dds/link/arrival_tick.hpp"
#include "dds/link/blocked_writes.hpp"
#include "dds/link/peer_watch.hpp"
#include "dds/link/state_news.hpp"
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
  if (options.damping_kd >= kMinKd && options.damping_kd <= kMaxKd) return options;
  throw Error("damping_kd: got " + to_text(options.damping_kd) + ", expected " + to_text(kMinKd) +
              " .. " + to_text(kMaxKd) + " [N.m.s/rad]");
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
        writer(network->participant(), unitree_go_msg_dds__LowCmd__desc, kCommandTopic),
        blocked(network->participant(), kCommandTopic),
        news(o.tick) {
    peers.start(writer.guid());
    to_dds(damping_low_cmd(o.damping_kd), o.robot, o.damping_kd, damping);
    std::memset(&sample, 0, sizeof(sample));
  }
  bool take_samples() noexcept;
  bool is_from_robot(std::uint64_t source, double time) noexcept;
  bool process_sample(double time) noexcept;
  bool in_conflict(double time) const noexcept {
    return peers.conflict() || time - second_robot_time < kSecondRobotTime;
  }
  const DdsLowCmd* choose(bool usable) noexcept;

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
  BlockedWrites blocked;
  StateNews news;
};

DdsLink::DdsLink(std::shared_ptr<DdsNetwork> network, const DdsLinkOptions& options)
    : impl_(std::make_unique<Impl>(std::move(network), options)) {}
DdsLink::~DdsLink() = default;

bool DdsLink::receive() noexcept {
  const double time = monotonic_time();
  impl_->intake.status.conflict = impl_->in_conflict(time);
  const bool newer = impl_->take_samples();
  impl_->news.on_receive(time);
  return newer;
}

bool DdsLink::Impl::take_samples() noexcept {
  bool newer = false;
  for (int k = 0; k < kMaxSamplesPerReceive; ++k) {
    const double start = monotonic_time();
    std::uint64_t source = 0;
    if (!reader.take(&sample, &source)) {
      last_empty_time = start;
      return newer;
    }
    // The stamp belongs to the newest sample, and may be one sample late.
    const double now = monotonic_time();
    const double arrival = std::clamp(reader.last_arrival(), last_empty_time, now);
    if (!is_from_robot(source, now)) continue;
    const std::uint64_t valid = intake.status.counts.valid;
    newer = process_sample(arrival) || newer;
    if (intake.status.counts.valid > valid) robot_writer = source;
  }
  ++intake.status.counts.floods;
  return newer;
}

// Return whether a sample comes from the writer whose LowStates are used. If another writer is the
// only one left, the robot has restarted. Otherwise the sample is one of a second robot: a
// conflict.
bool DdsLink::Impl::is_from_robot(std::uint64_t source, double time) noexcept {
  if (robot_writer == 0 || source == robot_writer) return true;
  if (peers.only_writer(kStateRule) == source) {
    robot_writer = 0;  // the next valid LowState decides
    intake.restart();
    return true;
  }
  ++counts.second_robot;
  second_robot_time = time;
  intake.status.conflict = true;
  news.on_second_robot(counts.second_robot);
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
  news.on_valid(counts, time);
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
  s.blocked.on_write(result);
  s.counts.timeouts = s.blocked.count();
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

std::vector<std::string> DdsLink::take_news() {
  std::vector<std::string> news = impl_->peers.take_news();
  impl_->news.add_to(news, impl_->peers.owners(kStateRule));
  impl_->blocked.add_to(news);
  return news;
}

}  // namespace surefoot
