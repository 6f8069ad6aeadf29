// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "dds/network/endpoints.hpp"

namespace surefoot {

/// Wait for some milliseconds.
void pause(int milliseconds);

/// Wait for at most 2 s until a condition is true; return whether it was.
template <typename Condition>
bool wait_until(Condition&& condition) {
  for (int k = 0; k < 400; ++k) {
    if (condition()) return true;
    pause(5);
  }
  return false;
}

/// The end of a go2 in a link: writes rt/lowstate, reads rt/lowcmd.
struct RobotEnd {
  explicit RobotEnd(const DdsParticipant& participant);

  /// Send a LowState at rest.
  /// @param with_crc false: crc 0
  void send_state(std::uint32_t tick, bool with_crc = true);
  /// Return tau of motor 0 in the newest command; NaN: damping, infinity: no command arrived. Every
  /// command must have a right CRC, and all motors in servo mode.
  double tau();

  DdsWriter writer;
  DdsReader reader;
};

/// A reader that can block writers of its topic, as a subscriber of ROS 2 with default settings.
class ReliableReader {
 public:
  ReliableReader(const DdsParticipant& participant, const dds_topic_descriptor_t& type,
                 const char* topic);

 private:
  DdsEntity topic_, reader_;
};

}  // namespace surefoot
