// SPDX-License-Identifier: BSD-3-Clause
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include "bindings.hpp"
#include "surefoot/dds_link.hpp"
#include "surefoot/error.hpp"
#include "value_class.hpp"

using namespace nb::literals;
using namespace surefoot;

namespace {

TickSource to_tick_source(const std::string& name) {
  if (name == "message") return TickSource::kMessage;
  if (name == "arrival") return TickSource::kArrival;
  throw Error("tick: got '" + name + "', expected message or arrival");
}

void bind_counts(nb::module_& m) {
  ValueClass<DdsCounts>(m, "DdsCounts", "Counts of a DdsLink beyond LinkCounts.")
      .def_ro("timeouts", &DdsCounts::timeouts,
              "Commands that a slow reliable reader blocked for 1 ms.")
      .def_ro("conflicts", &DdsCounts::conflicts,
              "Commands that were not sent because of RobotLink.conflict; damping was sent, or\n"
              "nothing.")
      .def_ro("withheld", &DdsCounts::withheld, "Those of conflicts for which nothing was sent.")
      .def_ro("without_crc", &DdsCounts::without_crc,
              "Valid LowStates whose crc was 0, so no CRC was checked.")
      .def_ro("without_head", &DdsCounts::without_head,
              "Valid LowStates without a head, whose motors are taken for being in servo\n"
              "mode.")
      .def_ro("second_robot", &DdsCounts::second_robot,
              "LowStates of another writer than that of the first valid LowState; they are not\n"
              "used.")
      .def_ro("without_tick", &DdsCounts::without_tick, "Valid LowStates whose tick was 0.");
}

}  // namespace

void bind_dds_link(nb::module_& m) {
  bind_counts(m);
  nb::class_<DdsLink, RobotLink>(
      m, "DdsLink",
      "Link to a Go2 or B2 over DDS: writes rt/lowcmd, reads rt/lowstate.\n\n"
      "Until a valid LowState has arrived, only damping is sent, whatever command is\n"
      "given. All 20 motors are always in servo mode, and every command has a CRC. Not\n"
      "thread-safe, except for take_news(). For a real robot use Runner.\n\n"
      "A thread of the link looks for other writers every 10 ms. They are a conflict.\n"
      "Beside another writer of rt/lowcmd the link sends damping 10 times, and then nothing\n"
      "until that writer has gone, because the commands of two programs in turn are not\n"
      "safe. If no command of the caller has been sent yet, the link sends nothing at once.\n"
      "With a second writer of rt/lowstate it sends only damping. Only LowStates of one\n"
      "writer are used: that of the first valid LowState, until it has gone.")
      .def(
          "__init__",
          [](DdsLink* self, std::shared_ptr<DdsNetwork> network, const std::string& robot,
             double damping_kd, bool require_crc, const std::string& tick, double discovery_time) {
            const CrcRule crc = require_crc ? CrcRule::kRequired : CrcRule::kZeroIsAbsent;
            new (self) DdsLink(std::move(network), {to_dds_robot(robot), damping_kd, crc,
                                                    to_tick_source(tick), discovery_time});
          },
          "network"_a, "robot"_a, "damping_kd"_a = 3.0, "require_crc"_a = false,
          "tick"_a = "message", "discovery_time"_a = 1.0, nb::call_guard<nb::gil_scoped_release>(),
          "Open the link; takes discovery_time.\n\n"
          "Args:\n"
          "    network: The domain and the interface.\n"
          "    robot: 'go2' or 'b2'; it decides the servo mode of the motors.\n"
          "    damping_kd: kd in the damping commands that the link itself sends\n"
          "        [N.m.s/rad], 0.0625 .. 50.\n"
          "    require_crc: If True, LowStates with crc 0 are refused. Otherwise they are\n"
          "        accepted without a check, as from unitree_mujoco's Python simulator.\n"
          "    tick: 'message', or 'arrival': the tick is made from the time of arrival\n"
          "        while that of the messages stands at 0.\n"
          "    discovery_time: Time that peers get to be discovered before their types and\n"
          "        writers are checked [s], 0 .. 60.\n\n"
          "Raises:\n"
          "    Error: An argument is out of range, a writer of another type than that of Go2\n"
          "        and B2 is on rt/lowstate or rt/lowcmd, another writer is on rt/lowcmd, or\n"
          "        two writers are on rt/lowstate. The message names their processes.")
      .def_prop_ro(
          "dds_counts", [](const DdsLink& link) { return DdsCounts(link.dds_counts()); },
          "Counts since the link was opened, a copy.")
      .def("take_news", &DdsLink::take_news,
           "Return what has changed since the last call, as sentences: peers that came or\n"
           "vanished, 0.1 s without a valid LowState, missing CRCs, a tick that stands still,\n"
           "commands that timed out and the readers that can block them. From any thread, one\n"
           "at a time.");
}
