// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "surefoot/dds_network.hpp"
#include "surefoot/dds_robot.hpp"
#include "surefoot/frames.hpp"

namespace surefoot {

/// Counts of a DdsRobotPort since it was opened.
struct RobotPortCounts {
  std::uint64_t received = 0;    ///< commands that arrived, valid or not
  std::uint64_t commands = 0;    ///< valid commands
  std::uint64_t overtaken = 0;   ///< valid commands that a newer one replaced in the same receive()
  std::uint64_t repeated = 0;    ///< valid commands equal to the one before
  std::uint64_t blank = 0;       ///< commands of zeros only
  std::uint64_t wrong_crc = 0;   ///< commands with a wrong CRC, also crc 0
  std::uint64_t not_finite = 0;  ///< commands with NaN or infinity
  std::uint64_t not_servo = 0;   ///< valid commands with a motor 0 .. 11 not in servo mode
  std::uint64_t sent = 0;        ///< LowStates sent
  std::uint64_t unsent = 0;      ///< LowStates that could not be sent
};

/// The end of a simulated Go2 or B2: writes rt/lowstate, reads rt/lowcmd.
///
/// Not thread-safe.
class DdsRobotPort {
 public:
  /// Open the port; takes discovery_time [s], 0 .. 60. Throws surefoot::Error if discovery_time is
  /// out of range, if another writer of rt/lowstate exists, or a writer of rt/lowcmd of another
  /// type; the message names its process.
  DdsRobotPort(std::shared_ptr<DdsNetwork> network, DdsRobot robot, double discovery_time = 1.0);
  ~DdsRobotPort();
  DdsRobotPort(const DdsRobotPort&) = delete;
  DdsRobotPort& operator=(const DdsRobotPort&) = delete;

  /// Take the waiting commands. Motors that are not in the servo mode of the robot get
  /// kModeDamping. Never blocks. Real-time: yes; libddsc may lock and allocate.
  /// @param newest receives the newest valid command, if one has arrived
  /// @return true if a valid command has arrived
  bool receive(LowCmd& newest) noexcept;
  /// Send a LowState with its CRC. Blocks for at most 1 ms. Real-time: yes; libddsc may lock and
  /// allocate.
  /// @return true if it was sent; false if a number is not finite, or if libddsc refused it
  bool send(const LowState& state) noexcept;

  /// Create or delete a second writer of rt/lowcmd, as the sport service of a robot has one. It
  /// writes nothing. Throws surefoot::Error if libddsc cannot create it.
  void set_sport_service(bool active);
  const RobotPortCounts& counts() const noexcept;  ///< counts since the port was opened
  /// Return sentences about writers that came or vanished since the last call, and about LowStates
  /// that a slow reader blocked.
  std::vector<std::string> take_news();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace surefoot
