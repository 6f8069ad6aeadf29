// SPDX-License-Identifier: BSD-3-Clause
#include "bindings.hpp"
#include "surefoot/safety.hpp"

namespace nb = nanobind;
using namespace nb::literals;
using namespace surefoot;

namespace {

constexpr const char* kSafety =
    "The SDK's three protections: names, arguments and defaults of its safety.h, in snake case.\n\n"
    "They are software and guarantee nothing. Beginners should use all of them, with level 1.\n"
    "Position limits are the robot's own, RobotConfig.q_lower and q_upper: the SDK's and the\n"
    "URDF's intersected, so nowhere wider than the vendor's. Motors 12 .. 19 are ignored.";

constexpr const char* kPowerProtect =
    "Judge the power of the motors, sum |tauEst dq|, against level times 100 W.\n\n"
    "Call it once a report and do not send what it refuses. A counter goes up by one (to 10 at\n"
    "most) with each call above the limit, else down by one (to 0), and above 5 it trips: a\n"
    "lasting overload trips on the 6th call, and at most 4 quiet calls are refused after it.\n\n"
    "The vendor's library also writes mode 0x00 into the command and never trips on NaN; here\n"
    "the command stays as it is, as the SDK's document says, and a power that is not finite is\n"
    "refused at once. Level n is n x 100 W on every robot, b1 included, whose body takes 4 to\n"
    "12 times the watts of a go1's in pushes of the same share of what it survives.\n\n"
    "Args:\n"
    "    cmd: Not read.\n"
    "    state: tauEst [N.m] and dq [rad/s] of motors 0 .. 11.\n"
    "    level: 1 .. 10, clamped.\n\n"
    "Returns:\n"
    "    +1, or -1 when tripped. Real-time: yes.";

constexpr const char* kPositionProtect =
    "Judge the joint angles measured: each within [q_lower + limit, q_upper - limit].\n\n"
    "No debounce, no latch; NaN is outside. The vendor's library also writes mode 0x00 into the\n"
    "command; here it stays as it is. The limit of 10 (radians) in a comment of the vendor's\n"
    "examples leaves no window and trips always, and so does NaN.\n\n"
    "Args:\n"
    "    cmd: Not read.\n"
    "    state: q [rad] of motors 0 .. 11.\n"
    "    limit: Kept from either end [rad].\n\n"
    "Returns:\n"
    "    +1, or -1 when a joint is outside: position_motor. Real-time: yes.";

constexpr const char* kPositionLimit =
    "Clamp the position commands q of motors 0 .. 11 to the joints' limits, in place.\n\n"
    "|q| >= 1e9 is PosStopF (2.146e9, or the 1e9 of the vendor's Python examples) and stays; the\n"
    "vendor's library turns it into the joint's upper limit. NaN passes: encoding refuses it.\n\n"
    "Args:\n"
    "    cmd: Changed in place. Real-time: yes.";

}  // namespace

void bind_safety(nb::module_& m) {
  nb::class_<Safety>(m, "Safety", kSafety)
      .def(nb::init<const Robot&>(), "robot"_a)
      .def("power_protect", &Safety::power_protect, "cmd"_a, "state"_a, "level"_a, kPowerProtect)
      .def("position_protect", &Safety::position_protect, "cmd"_a, "state"_a,
           "limit"_a = Safety::kPositionMargin, kPositionProtect)
      .def("position_limit", &Safety::position_limit, "cmd"_a, kPositionLimit)
      .def_prop_ro("power", &Safety::power, "Sum |tauEst dq| of the last power_protect() [W].")
      .def_prop_ro("power_counter", &Safety::power_counter,
                   "0 .. 10; power_protect() trips above 5.")
      .def_prop_ro("position_motor", &Safety::position_motor,
                   "SDK motor that the last position_protect() found outside, or -1.")
      .def_prop_ro("position_angle", &Safety::position_angle,
                   "Its angle [rad]; 0 where there is none.")
      .def("reset", &Safety::reset, "Forget all calls so far.");
}
