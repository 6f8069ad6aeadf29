// SPDX-License-Identifier: BSD-3-Clause
#include "surefoot/dds_robot_port.hpp"

#include <cstring>
#include <limits>
#include <optional>

#include "dds/link/blocked_writes.hpp"
#include "dds/link/peer_watch.hpp"
#include "dds/link/topics.hpp"
#include "dds/network/endpoints.hpp"
#include "dds/wire/low_cmd_conversion.hpp"
#include "dds/wire/low_state_conversion.hpp"
#include "surefoot/error.hpp"

namespace surefoot {

namespace {

std::vector<WriterRule> robot_rules() {
  return {{kStateTopic, unitree_go_msg_dds__LowState__desc.m_typename, 0,
           "end the other robot, or choose another domain or interface"},
          {kCommandTopic, unitree_go_msg_dds__LowCmd__desc.m_typename,
           std::numeric_limits<std::size_t>::max(), ""}};
}

bool all_in_servo_mode(const LowCmd& cmd) noexcept {
  for (int i = 0; i < kMotors; ++i) {
    if (cmd.motorCmd[i].mode != kModeServo) return false;
  }
  return true;
}

}  // namespace

struct DdsRobotPort::Impl {
  Impl(std::shared_ptr<DdsNetwork> n, DdsRobot r, double discovery_time)
      : robot(r),
        network(std::move(n)),
        reader(participant_of(network), unitree_go_msg_dds__LowCmd__desc, kCommandTopic),
        peers(network->participant(), robot_rules(), discovery_time),
        writer(network->participant(), unitree_go_msg_dds__LowState__desc, kStateTopic),
        blocked(network->participant(), kStateTopic) {
    peers.start(writer.guid());
    std::memset(&command, 0, sizeof(command));
    std::memset(&last_command, 0, sizeof(last_command));
  }
  bool read_command(LowCmd& out) noexcept;

  DdsRobot robot;
  std::shared_ptr<DdsNetwork> network;
  DdsReader reader;
  PeerWatch peers;
  DdsWriter writer;
  BlockedWrites blocked;
  std::optional<DdsWriter> sport_service;
  DdsLowCmd command, last_command;
  DdsLowState state;
  RobotPortCounts counts;
};

DdsRobotPort::DdsRobotPort(std::shared_ptr<DdsNetwork> network, DdsRobot robot,
                           double discovery_time)
    : impl_(std::make_unique<Impl>(std::move(network), robot, discovery_time)) {}
DdsRobotPort::~DdsRobotPort() = default;

bool DdsRobotPort::receive(LowCmd& newest) noexcept {
  Impl& s = *impl_;
  bool received = false;
  for (int k = 0; k < DdsReader::kDepth && s.reader.take(&s.command); ++k) {
    ++s.counts.received;
    if (!s.read_command(newest)) continue;
    s.counts.overtaken += received;
    received = true;
  }
  return received;
}

bool DdsRobotPort::Impl::read_command(LowCmd& out) noexcept {
  const FrameReport report = from_dds(command, robot, CrcRule::kRequired, out);
  if (report.status == FrameStatus::kOk) {
    ++counts.commands;
    counts.repeated += std::memcmp(&command, &last_command, sizeof(command)) == 0;
    counts.not_servo += !all_in_servo_mode(out);
    std::memcpy(&last_command, &command, sizeof(command));
    return true;
  }
  counts.blank += report.status == FrameStatus::kBlank;
  counts.wrong_crc += report.status == FrameStatus::kWrongCrc;
  counts.not_finite += report.status == FrameStatus::kNotFinite;
  return false;
}

bool DdsRobotPort::send(const LowState& state) noexcept {
  Impl& s = *impl_;
  bool was_sent = false;
  if (is_usable(to_dds(state, s.robot, s.state).status)) {
    const ddsc::Return result = s.writer.write(&s.state);
    s.blocked.on_write(result);
    was_sent = result == 0;
  }
  ++(was_sent ? s.counts.sent : s.counts.unsent);
  return was_sent;
}

void DdsRobotPort::set_sport_service(bool active) {
  Impl& s = *impl_;
  if (!active) {
    s.sport_service.reset();
  } else if (!s.sport_service) {
    s.sport_service.emplace(s.network->participant(), unitree_go_msg_dds__LowCmd__desc,
                            kCommandTopic);
  }
}

const RobotPortCounts& DdsRobotPort::counts() const noexcept { return impl_->counts; }
std::vector<std::string> DdsRobotPort::take_news() {
  std::vector<std::string> news = impl_->peers.take_news();
  impl_->blocked.add_to(news);
  return news;
}

}  // namespace surefoot
