// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <limits>

#include "surefoot/frames.hpp"

namespace surefoot {

/// Counts of commands sent and messages received since the link was opened. A message is a datagram
/// (UDP) or a sample (DDS).
struct LinkCounts {
  std::uint64_t sent = 0;         ///< commands sent, damping included
  std::uint64_t send_failed = 0;  ///< commands that the system did not accept
  std::uint64_t refused = 0;      ///< commands that were not finite; damping was sent instead
  std::uint64_t received = 0;     ///< messages from the peer, valid or not
  std::uint64_t valid = 0;        ///< valid LowStates of the expected generation
  std::uint64_t lost = 0;         ///< LowStates that are missing in the tick sequence
  std::uint64_t late = 0;  ///< new LowStates that arrived more than 10 ms after the previous one
  std::uint64_t duplicate = 0;  ///< LowStates whose tick had already arrived
  std::uint64_t reordered = 0;  ///< LowStates counted as lost, then received after a newer one
  /// Restarts of the robot: five consecutive LowStates whose ticks increase but are all older than
  /// the newest tick; over DDS also a new writer of LowStates after the old one has gone.
  std::uint64_t restarts = 0;
  std::uint64_t corrupt = 0;           ///< messages with the right length but no valid LowState
  std::uint64_t wrong_generation = 0;  ///< frames of another generation; UDP only
  std::uint64_t wrong_length = 0;      ///< datagrams whose length fits no generation; UDP only
  std::uint64_t strangers = 0;         ///< datagrams from other senders than the peer; UDP only
  std::uint64_t floods = 0;  ///< calls of receive() that read the maximum number of messages
};

/// State of a link to a robot.
struct LinkStatus {
  bool has_state = false;             ///< true once a valid LowState has arrived
  LowState state = init_low_state();  ///< newest LowState
  double arrival_time = 0.0;          ///< [s] arrival of `state` on CLOCK_MONOTONIC
  LinkCounts counts;                  ///< counts since the link was opened
  FrameReport last_reject;            ///< why the last invalid message was rejected
  /// True while another program commands the robot, or a second robot sends LowStates. The link
  /// then sends damping or nothing, see DdsLink. Only a DDS link detects this.
  bool conflict = false;
};

/// Link to a robot: sends LowCmds and receives LowStates. UdpLink and DdsLink implement it.
///
/// Until a valid LowState has arrived, only damping is sent, whatever command is given. Not
/// thread-safe.
class RobotLink {
 public:
  virtual ~RobotLink() = default;

  /// Read the waiting messages and keep the newest valid LowState. Never blocks. Real-time: yes.
  /// @return true if a newer LowState has arrived; see state_age() for its age
  virtual bool receive() noexcept = 0;
  /// Send a command. Until has_state() is true, or if the command is not finite, damping is sent
  /// instead. Real-time: yes.
  /// @return how the command was encoded; kNotFinite: damping was sent instead
  virtual FrameReport send(const LowCmd& cmd) noexcept = 0;
  virtual const LinkStatus& status() const noexcept = 0;  ///< present state of the link
  /// Whether the link may lead to a real robot: its options allow more than this machine.
  virtual bool allows_real_robot() const noexcept = 0;

  /// true once a valid LowState has arrived
  bool has_state() const noexcept { return status().has_state; }
  const LowState& state() const noexcept { return status().state; }  ///< newest LowState
  double state_age() const noexcept;  ///< [s] time since state() arrived; infinity before the first
  /// counts since the link was opened
  const LinkCounts& counts() const noexcept { return status().counts; }
  /// why the last invalid message was rejected
  const FrameReport& last_reject() const noexcept { return status().last_reject; }

 protected:
  RobotLink() = default;
  RobotLink(const RobotLink&) = default;  ///< only for classes that can be copied
  RobotLink(RobotLink&&) = default;       ///< only for classes that can be moved
};

}  // namespace surefoot
