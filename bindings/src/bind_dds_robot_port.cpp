// SPDX-License-Identifier: BSD-3-Clause
#include <nanobind/stl/optional.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <optional>

#include "bindings.hpp"
#include "surefoot/dds_robot_port.hpp"
#include "value_class.hpp"

using namespace nb::literals;
using namespace surefoot;

namespace {

void bind_counts(nb::module_& m) {
  ValueClass<RobotPortCounts>(m, "RobotPortCounts", "Counts of a DdsRobotPort since it was opened.")
      .def_ro("received", &RobotPortCounts::received, "Commands that arrived, valid or not.")
      .def_ro("commands", &RobotPortCounts::commands, "Valid commands.")
      .def_ro("overtaken", &RobotPortCounts::overtaken,
              "Valid commands that a newer one replaced in the same receive().")
      .def_ro("repeated", &RobotPortCounts::repeated, "Valid commands equal to the one before.")
      .def_ro("blank", &RobotPortCounts::blank, "Commands of zeros only.")
      .def_ro("wrong_crc", &RobotPortCounts::wrong_crc, "Commands with a wrong CRC, also crc 0.")
      .def_ro("not_finite", &RobotPortCounts::not_finite, "Commands with NaN or infinity.")
      .def_ro("not_servo", &RobotPortCounts::not_servo,
              "Valid commands with a motor 0 .. 11 not in servo mode.")
      .def_ro("sent", &RobotPortCounts::sent, "LowStates sent.")
      .def_ro("unsent", &RobotPortCounts::unsent, "LowStates that could not be sent.");
}

}  // namespace

void bind_dds_robot_port(nb::module_& m) {
  bind_counts(m);
  nb::class_<DdsRobotPort>(
      m, "DdsRobotPort",
      "The end of a simulated Go2 or B2: writes rt/lowstate, reads rt/lowcmd.\n\n"
      "Not thread-safe.")
      .def(
          "__init__",
          [](DdsRobotPort* self, std::shared_ptr<DdsNetwork> network, const std::string& robot,
             double discovery_time) {
            new (self) DdsRobotPort(std::move(network), to_dds_robot(robot), discovery_time);
          },
          "network"_a, "robot"_a, "discovery_time"_a = 1.0,
          nb::call_guard<nb::gil_scoped_release>(),
          "Open the port; takes discovery_time [s], 0 .. 60.\n\n"
          "Raises:\n"
          "    Error: The robot is neither 'go2' nor 'b2', discovery_time is out of range,\n"
          "        another writer of rt/lowstate exists, or a writer of rt/lowcmd of another\n"
          "        type. The message names its process.")
      .def(
          "receive",
          [](DdsRobotPort& port) {
            LowCmd cmd = init_low_cmd();
            return port.receive(cmd) ? std::optional<LowCmd>(cmd) : std::nullopt;
          },
          "Return the newest valid command that waits, or None. Motors that are not in the\n"
          "servo mode of the robot get mode 0x00. Never blocks.")
      .def("send", &DdsRobotPort::send, "state"_a,
           "Send a LowState with its CRC; return whether it was sent. Blocks for at most 1 ms.")
      .def("set_sport_service", &DdsRobotPort::set_sport_service, "active"_a,
           "Create or delete a second writer of rt/lowcmd, as the sport service of a robot\n"
           "has one. It writes nothing.")
      .def_prop_ro(
          "counts", [](const DdsRobotPort& port) { return RobotPortCounts(port.counts()); },
          "Counts since the port was opened, a copy.")
      .def("take_news", &DdsRobotPort::take_news,
           "Return sentences about writers that came or vanished since the last call, and about\n"
           "LowStates that a slow reader blocked.");
}
