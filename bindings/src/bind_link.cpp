// SPDX-License-Identifier: BSD-3-Clause
#include <nanobind/stl/string.h>

#include "bindings.hpp"
#include "surefoot/error.hpp"
#include "surefoot/udp_link.hpp"

namespace nb = nanobind;
using namespace nb::literals;
using namespace surefoot;

namespace {

void bind_counts(nb::module_& m) {
  nb::class_<LinkCounts>(m, "LinkCounts",
                         "Counts of frames sent and datagrams received since the link was opened.")
      .def_ro("sent", &LinkCounts::sent, "Frames sent, damping included.")
      .def_ro("send_failed", &LinkCounts::send_failed, "Frames that the system did not accept.")
      .def_ro("refused", &LinkCounts::refused,
              "Commands that were not finite; damping was sent instead.")
      .def_ro("received", &LinkCounts::received, "Datagrams from the peer, valid or not.")
      .def_ro("valid", &LinkCounts::valid, "Valid LowStates of the expected generation.")
      .def_ro("lost", &LinkCounts::lost,
              "LowStates missing by the sequence of ticks, long gaps included.")
      .def_ro("late", &LinkCounts::late, "New LowStates more than 10 ms after the one before.")
      .def_ro("duplicate", &LinkCounts::duplicate, "LowStates whose tick had arrived before.")
      .def_ro("reordered", &LinkCounts::reordered,
              "LowStates older than the newest that had been missing.")
      .def_ro("restarts", &LinkCounts::restarts,
              "Restarts of the tick sequence: five rising ticks in a row from behind.")
      .def_ro("corrupt", &LinkCounts::corrupt,
              "Datagrams of the right length that are not a valid frame.")
      .def_ro("wrong_generation", &LinkCounts::wrong_generation, "Frames of another generation.")
      .def_ro("wrong_length", &LinkCounts::wrong_length,
              "Datagrams with the length of no generation.")
      .def_ro("strangers", &LinkCounts::strangers, "Datagrams from other senders than the peer.")
      .def_ro("floods", &LinkCounts::floods,
              "Calls of receive() that read the maximum of 64 datagrams.");
}

void bind_udp_link(nb::module_& m) {
  nb::class_<UdpLink>(
      m, "UdpLink",
      "Client of the robot's UDP port on this machine: sends LowCmd frames, receives\n"
      "LowState frames.\n\n"
      "Datagrams from other senders than the peer are ignored. Until a valid LowState\n"
      "has shown that the robot uses the expected generation, only damping frames are\n"
      "sent, whatever command is given. The age of a state counts from its arrival at\n"
      "this machine. Not thread-safe. For a real robot use StandRunner.")
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
          "    damping_kd: Damping in the link's own damping frames [N.m.s/rad], 0.0625 ..\n"
          "        50.\n\n"
          "Raises:\n"
          "    Error: Unknown host or generation, no loopback address, a port out of range,\n"
          "        in use or not permitted, damping_kd out of range.")
      .def("receive", &UdpLink::receive,
           "Read the waiting datagrams, at most 64, and keep the newest valid LowState.\n\n"
           "Never blocks. Real-time: yes.\n\n"
           "Returns:\n"
           "    True if a newer LowState has arrived; see state_age for its age.")
      .def(
          "send", [](UdpLink& link, const LowCmd& cmd) { return to_text(link.send(cmd)); }, "cmd"_a,
          "Send a command; send damping instead before has_state or if it is not finite.\n\n"
          "Never blocks. Real-time: yes.\n\n"
          "Returns:\n"
          "    'ok', or a sentence about the fields that were saturated or not finite.")
      .def_prop_ro("has_state", &UdpLink::has_state, "True once a valid LowState has arrived.")
      .def_prop_ro(
          "state", [](const UdpLink& link) { return LowState(link.state()); },
          "Newest LowState, a copy.")
      .def_prop_ro("state_age", &UdpLink::state_age,
                   "Time since state arrived [s]; inf before the first.")
      .def_prop_ro(
          "counts", [](const UdpLink& link) { return LinkCounts(link.counts()); },
          "Counts since the link was opened, a copy.")
      .def_prop_ro(
          "last_reject", [](const UdpLink& link) { return to_text(link.last_reject()); },
          "Why the last invalid datagram was rejected, in a sentence.")
      .def_prop_ro("local_port", &UdpLink::local_port, "Local UDP port.");
}

}  // namespace

void bind_link(nb::module_& m) {
  bind_counts(m);
  bind_udp_link(m);
}
