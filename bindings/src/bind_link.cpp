// SPDX-License-Identifier: BSD-3-Clause
#include <nanobind/stl/string.h>

#include "bindings.hpp"
#include "surefoot/error.hpp"
#include "surefoot/udp_link.hpp"
#include "value_class.hpp"

using namespace nb::literals;
using namespace surefoot;

namespace {

void bind_counts(nb::module_& m) {
  ValueClass<LinkCounts>(
      m, "LinkCounts",
      "Counts of commands sent and messages received since the link was opened.\n\n"
      "A message is a datagram (UDP) or a sample (DDS).")
      .def_ro("sent", &LinkCounts::sent, "Commands sent, damping included.")
      .def_ro("send_failed", &LinkCounts::send_failed, "Commands that the system did not accept.")
      .def_ro("refused", &LinkCounts::refused,
              "Commands that were not finite; damping was sent instead.")
      .def_ro("received", &LinkCounts::received, "Messages from the peer, valid or not.")
      .def_ro("valid", &LinkCounts::valid, "Valid LowStates of the expected generation.")
      .def_ro("lost", &LinkCounts::lost,
              "LowStates that are missing in the tick sequence, long gaps included.")
      .def_ro("late", &LinkCounts::late,
              "New LowStates that arrived more than 10 ms after the previous one.")
      .def_ro("duplicate", &LinkCounts::duplicate, "LowStates whose tick had already arrived.")
      .def_ro("reordered", &LinkCounts::reordered,
              "LowStates counted as lost, then received after a newer one.")
      .def_ro("restarts", &LinkCounts::restarts,
              "Restarts of the robot.\n\n"
              "A restart is counted after five consecutive LowStates whose ticks increase but\n"
              "are all older than the newest tick.")
      .def_ro("corrupt", &LinkCounts::corrupt,
              "Messages with the right length but no valid LowState.")
      .def_ro("wrong_generation", &LinkCounts::wrong_generation,
              "Frames of another generation; UDP only.")
      .def_ro("wrong_length", &LinkCounts::wrong_length,
              "Datagrams whose length fits no generation; UDP only.")
      .def_ro("strangers", &LinkCounts::strangers,
              "Datagrams from other senders than the peer;\n"
              "UDP only.")
      .def_ro("floods", &LinkCounts::floods,
              "Calls of receive() that read the maximum number of messages.");
}

void bind_robot_link(nb::module_& m) {
  nb::class_<RobotLink>(
      m, "RobotLink",
      "Link to a robot: sends LowCmds and receives LowStates. UdpLink and DdsLink are\n"
      "such links.\n\n"
      "Until a valid LowState has arrived, only damping is sent, whatever command is\n"
      "given. Not thread-safe.")
      .def("receive", &RobotLink::receive,
           "Read the waiting messages and keep the newest valid LowState.\n\n"
           "Never blocks. Real-time: yes.\n\n"
           "Returns:\n"
           "    True if a newer LowState has arrived; see state_age for its age.")
      .def(
          "send", [](RobotLink& link, const LowCmd& cmd) { return to_text(link.send(cmd)); },
          "cmd"_a,
          "Send a command. Until has_state is True, or if the command is not finite,\n"
          "damping is sent instead.\n\n"
          "Real-time: yes.\n\n"
          "Returns:\n"
          "    'ok', or a sentence about the fields that were saturated or not finite.")
      .def_prop_ro("has_state", &RobotLink::has_state, "True once a valid LowState has arrived.")
      .def_prop_ro(
          "state", [](const RobotLink& link) { return LowState(link.state()); },
          "Newest LowState, a copy.")
      .def_prop_ro("state_age", &RobotLink::state_age,
                   "Time since the newest LowState arrived [s]; inf before the first LowState.")
      .def_prop_ro(
          "counts", [](const RobotLink& link) { return LinkCounts(link.counts()); },
          "Counts since the link was opened, a copy.")
      .def_prop_ro(
          "last_reject", [](const RobotLink& link) { return to_text(link.last_reject()); },
          "Reason why the last invalid message was rejected, a sentence.")
      .def_prop_ro("allows_real_robot", &RobotLink::allows_real_robot,
                   "Whether the link may lead to a real robot: the real_robot of its options.")
      .def_prop_ro(
          "conflict", [](const RobotLink& link) { return link.status().conflict; },
          "True while another program commands the robot, or a second robot sends\n"
          "LowStates.\n\n"
          "The link then sends damping or nothing, see DdsLink. Only a DDS link detects this.");
}

void bind_udp_link(nb::module_& m) {
  nb::class_<UdpLink, RobotLink>(
      m, "UdpLink",
      "UDP client for a virtual robot on this machine: sends LowCmd frames and receives\n"
      "LowState frames.\n\n"
      "Datagrams from other senders than the peer are ignored. Until a valid LowState\n"
      "has shown that the robot uses the expected generation, only damping frames are\n"
      "sent, whatever command is given. state_age is measured from the arrival of the\n"
      "LowState at this machine, so the time that a LowState waits in the socket is\n"
      "included. Not thread-safe. For a real robot use Runner.")
      .def(
          "__init__",
          [](UdpLink* self, const std::string& host, int port, const std::string& generation,
             int local_port, double damping_kd) {
            new (self) UdpLink({host, port, local_port, to_generation(generation), damping_kd});
          },
          "host"_a = "127.0.0.1", "port"_a = 8007, "generation"_a = "go1-v3.8", "local_port"_a = 0,
          "damping_kd"_a = 3.0,
          "Open the link.\n\n"
          "Args:\n"
          "    host: IPv4 address or name; must be a loopback address, 127.x.x.x.\n"
          "    port: UDP port of the robot, 1 .. 65535.\n"
          "    generation: Frame format, one of surefoot.protocol.GENERATIONS.\n"
          "    local_port: Local UDP port; 0: any free port.\n"
          "    damping_kd: Kd in the damping frames that the link itself sends [N.m.s/rad],\n"
          "        0.0625 .. 50.\n\n"
          "Raises:\n"
          "    Error: The host or the generation is unknown, the host is not a loopback\n"
          "        address, a port is out of range, in use or not permitted, or damping_kd\n"
          "        is out of range.")
      .def_prop_ro("local_port", &UdpLink::local_port, "Local UDP port.");
}

}  // namespace

void bind_link(nb::module_& m) {
  bind_counts(m);
  bind_robot_link(m);
  bind_udp_link(m);
}
