// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "surefoot/dds_network.hpp"
#include "surefoot/dds_robot.hpp"
#include "surefoot/robot_link.hpp"

namespace surefoot {

/// Source of LowState::tick.
enum class TickSource {
  kMessage,  ///< the tick of the message
  /// the time of arrival while the tick of the messages stands at 0, as in unitree_mujoco's Python
  /// simulator; otherwise the tick of the message
  kArrival
};

/// Options of a DdsLink.
struct DdsLinkOptions {
  DdsRobot robot = DdsRobot::kGo2;  ///< robot; it decides the servo mode of the motors
  /// [N.m.s/rad] kd in the damping commands that the link itself sends, 0.0625 .. 50.
  double damping_kd = 3.0;
  CrcRule crc = CrcRule::kZeroIsAbsent;    ///< what a LowState with crc 0 means
  TickSource tick = TickSource::kMessage;  ///< source of LowState::tick
  /// [s] time that peers get to be discovered before their types and writers are checked, 0 .. 60
  double discovery_time = 1.0;
};

/// Counts of a DdsLink beyond LinkCounts.
struct DdsCounts {
  std::uint64_t timeouts = 0;  ///< commands that a slow reliable reader blocked for 1 ms
  /// commands that were not sent because of LinkStatus::conflict; damping was sent, or nothing
  std::uint64_t conflicts = 0;
  std::uint64_t withheld = 0;     ///< those of `conflicts` for which nothing was sent
  std::uint64_t without_crc = 0;  ///< valid LowStates whose crc was 0, so no CRC was checked
  /// valid LowStates without a head, whose motors are taken for being in servo mode
  std::uint64_t without_head = 0;
  /// LowStates of another writer than that of the first valid LowState; they are not used
  std::uint64_t second_robot = 0;
  std::uint64_t without_tick = 0;  ///< valid LowStates whose tick was 0
};

/// Link to a Go2 or B2 over DDS: writes rt/lowcmd, reads rt/lowstate.
///
/// Until a valid LowState has arrived, only damping is sent, whatever command is given. All 20
/// motors are always in servo mode, and every command has a CRC. Not thread-safe, except for
/// take_news().
///
/// Only LowStates of one writer are used: that of the first valid LowState, until it has gone.
///
/// A thread of the link looks for other writers every 10 ms. They are a conflict, see
/// LinkStatus::conflict:
///
/// - Another writer of rt/lowcmd: the link sends damping 10 times, and then nothing until that
///   writer has gone. If no command of the caller has been sent yet, the link sends nothing at
///   once. Otherwise the motors would get the commands of two programs in turn. Damping in turn
///   with another program's commands is not safe either. The last command of this link is damping,
///   so a robot that receives no other command does not keep a torque.
/// - A second writer of rt/lowstate, a writer of another type, or writers that cannot be read: the
///   link sends only damping, because no other program is known to command the robot. The first
///   LowState of a second writer is a conflict at once.
class DdsLink final : public RobotLink {
 public:
  /// Open the link; takes discovery_time. Throws surefoot::Error if an option is out of range, if a
  /// writer of another type than that of Go2 and B2 is on rt/lowstate or rt/lowcmd, if another
  /// writer is on rt/lowcmd, or if two writers are on rt/lowstate; the message names their
  /// processes.
  DdsLink(std::shared_ptr<DdsNetwork> network, const DdsLinkOptions& options);
  ~DdsLink() override;

  /// Take the waiting samples, at most kMaxSamplesPerReceive, and keep the newest valid LowState.
  /// Never blocks. Real-time: yes; libddsc may lock and allocate.
  /// @return true if a newer LowState has arrived; see state_age() for its age
  bool receive() noexcept override;
  static constexpr int kMaxSamplesPerReceive = 64;  ///< most samples that receive() takes

  /// Send a command. Until has_state() is true, or if the command is not finite, damping is sent
  /// instead. While status().conflict is true, damping or nothing is sent. Blocks for at most 1 ms.
  /// Real-time: yes; libddsc may lock and allocate.
  /// @return how the command was encoded; kNotFinite: it was not sent
  FrameReport send(const LowCmd& cmd) noexcept override;
  const LinkStatus& status() const noexcept override;  ///< present state of the link
  bool allows_real_robot() const noexcept override;    ///< DdsNetworkOptions::real_robot
  const DdsCounts& dds_counts() const noexcept;        ///< counts since the link was opened

  /// Return what has changed since the last call, as sentences: peers that came or vanished, 0.1 s
  /// without a valid LowState, missing CRCs, a tick that stands still, commands that timed out and
  /// the readers that can block them. From any thread, one at a time. Real-time: no.
  std::vector<std::string> take_news();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace surefoot
