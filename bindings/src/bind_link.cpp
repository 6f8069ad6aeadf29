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
  nb::class_<LinkCounts>(m, "LinkCounts", "What has come and gone since a link was opened.")
      .def_ro("sent", &LinkCounts::sent, "Commands on the wire.")
      .def_ro("send_failed", &LinkCounts::send_failed, "The system would not take them.")
      .def_ro("refused", &LinkCounts::refused, "Not finite: damping left instead.")
      .def_ro("received", &LinkCounts::received, "Datagrams of the peer, good or bad.")
      .def_ro("valid", &LinkCounts::valid, "LowStates of the right generation.")
      .def_ro("lost", &LinkCounts::lost, "Missing in the row of ticks, long silences included.")
      .def_ro("late", &LinkCounts::late, "More than 10 ms after the one before.")
      .def_ro("duplicate", &LinkCounts::duplicate, "A tick that had come before.")
      .def_ro("reordered", &LinkCounts::reordered, "Older than the newest, and had not come yet.")
      .def_ro("restarts", &LinkCounts::restarts, "Times that the ticks began anew.")
      .def_ro("corrupt", &LinkCounts::corrupt, "Of the right length, but no valid frame.")
      .def_ro("wrong_generation", &LinkCounts::wrong_generation, "Frames of another generation.")
      .def_ro("wrong_length", &LinkCounts::wrong_length, "Of no generation's length.")
      .def_ro("strangers", &LinkCounts::strangers, "Datagrams from someone else.")
      .def_ro("floods", &LinkCounts::floods, "Times more was waiting than is read at once.");
}

void bind_udp_link(nb::module_& m) {
  nb::class_<UdpLink>(m, "UdpLink",
                      "The client's side of a robot's UDP port; loopback only.\n\n"
                      "Datagrams count only if they come from the peer. Until a valid LowState has "
                      "come, nothing\nbut damping leaves, whatever is sent.")
      .def(
          "__init__",
          [](UdpLink* self, const std::string& host, int port, const std::string& generation,
             int local_port, double damping_kd) {
            new (self) UdpLink({host, port, local_port, to_generation(generation), damping_kd});
          },
          "host"_a = "127.0.0.1", "port"_a = 8007, "generation"_a = "go1-v3.8", "local_port"_a = 0,
          "damping_kd"_a = 3.0,
          "Raise Error: an unknown host or generation, no loopback, a port taken or out of range,\n"
          "damping_kd outside 0.0625 .. 50.")
      .def("receive", &UdpLink::receive,
           "Read what waits; has a newer LowState come? Never blocks.")
      .def(
          "send", [](UdpLink& link, const LowCmd& cmd) { return to_text(link.send(cmd)); }, "cmd"_a,
          "Put a command on the wire: 'ok', or what was saturated or refused.")
      .def_prop_ro("has_state", &UdpLink::has_state, "Has a valid LowState come?")
      .def_prop_ro(
          "state", [](const UdpLink& link) { return LowState(link.state()); }, "Newest, a copy.")
      .def_prop_ro("state_age", &UdpLink::state_age,
                   "[s] since the newest arrived; inf before the first.")
      .def_prop_ro(
          "counts", [](const UdpLink& link) { return LinkCounts(link.counts()); }, "A copy.")
      .def_prop_ro(
          "last_reject", [](const UdpLink& link) { return to_text(link.last_reject()); },
          "Why the last bad datagram was not taken.")
      .def_prop_ro("local_port", &UdpLink::local_port, "Ours.");
}

}  // namespace

void bind_link(nb::module_& m) {
  bind_counts(m);
  bind_udp_link(m);
}
