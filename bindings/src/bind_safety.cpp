// SPDX-License-Identifier: BSD-3-Clause
#include "bindings.hpp"
#include "surefoot/safety.hpp"

namespace nb = nanobind;
using namespace nb::literals;
using namespace surefoot;

namespace {

constexpr const char* kSafety =
    "The three protections of the SDK. Names (in snake case), arguments and defaults\n"
    "are those of its safety.h.\n\n"
    "They run in software and guarantee nothing: a robot is safe only if its\n"
    "controller sends no abnormal torques. Beginners should use all three, and set\n"
    "the power level to 1. The position limits are RobotConfig.q_lower and q_upper:\n"
    "the intersection of SDK and URDF limits, joint by joint. No limit is wider than\n"
    "the vendor's; on go1 some are narrower (hip 0.863 rad instead of 1.047 rad).\n"
    "Motors 12 .. 19 are ignored.";

constexpr const char* kPowerProtect =
    "Check the power of the motors, P = sum ``|tauEst dq|``, against 100 W times\n"
    "level.\n\n"
    "Call it once per sample, after computing the command and before sending it, and\n"
    "do not send the command if the result is -1. Each call whose P is above the\n"
    "limit increases a counter by one (up to 10). All other calls decrease the\n"
    "counter by one (down to 0). The protection trips above 5. So a lasting overload\n"
    "trips on the 6th call, and an overload in every other call never trips. The trip\n"
    "is not latched: after an overload at most 4 more calls return -1. P equal to the\n"
    "limit does not count as above it. The rule is that of the vendor's library, with\n"
    "these differences:\n\n"
    "- The command stays unchanged, as in the SDK's document. The vendor's library\n"
    "  writes mode 0x00 (brake) into motors 0 .. 11, and does not restore 0x0A.\n"
    "- If P is not finite, the same call returns -1, and P counts as above the limit.\n"
    "  The vendor's library never trips on NaN.\n"
    "- Nothing is printed, and the process never ends.\n\n"
    "A level means the same power on every robot. When both are pushed with the same\n"
    "fraction of their push limits, b1 takes 4 to 12 times the power of go1.\n"
    "Real-time: yes.\n\n"
    "Args:\n"
    "    cmd: Not read, as in the vendor's library.\n"
    "    state: tauEst [N.m] and dq [rad/s] of motors 0 .. 11.\n"
    "    level: 1 .. 10, clamped; may change from call to call.\n\n"
    "Returns:\n"
    "    +1, or -1 if tripped.";

constexpr const char* kPositionProtect =
    "Check the measured joint angles: each must be within [q_lower + limit, q_upper -\n"
    "limit].\n\n"
    "There is no debouncing and no latch: each call judges its own sample alone. NaN\n"
    "counts as outside the range. The command stays unchanged; the vendor's library\n"
    "writes mode 0x00 into the command. Note: a fully folded calf at rest is outside\n"
    "the range, so a lying robot trips. The check always trips if limit is NaN or\n"
    "leaves no range, for example the 10 rad in a comment of the vendor's examples. A\n"
    "negative limit widens the range. Real-time: yes.\n\n"
    "Args:\n"
    "    cmd: Not read.\n"
    "    state: q [rad] of motors 0 .. 11.\n"
    "    limit: Distance kept from both ends of the range [rad].\n\n"
    "Returns:\n"
    "    +1, or -1 if a joint is outside, see position_motor.";

constexpr const char* kPositionLimit =
    "Clamp the position commands q [rad] of motors 0 .. 11 to [q_lower, q_upper], in\n"
    "place.\n\n"
    "A command ``|q| >= 1e9`` counts as PosStopF and is not changed. (PosStopF is\n"
    "2.146e9; the vendor's Python examples use 1e9.) The vendor's library clamps such\n"
    "a command instead, so a motor with Kp > 0 moves to its upper limit. As in the\n"
    "vendor's library, mode and gains are ignored and NaN is not changed; encoding\n"
    "the frame refuses NaN. Real-time: yes.\n\n"
    "Args:\n"
    "    cmd: Command whose q is clamped.";

}  // namespace

void bind_safety(nb::module_& m) {
  nb::class_<Safety>(m, "Safety", kSafety)
      .def(nb::init<const Robot&>(), "robot"_a,
           "Copy the joint limits of the configuration of a robot.")
      .def("power_protect", &Safety::power_protect, "cmd"_a, "state"_a, "level"_a, kPowerProtect)
      .def("position_protect", &Safety::position_protect, "cmd"_a, "state"_a,
           "limit"_a = Safety::kPositionMargin, kPositionProtect)
      .def("position_limit", &Safety::position_limit, "cmd"_a, kPositionLimit)
      .def_prop_ro("power", &Safety::power,
                   "Power P [W] in the last call of power_protect(), or 0 before the first call.")
      .def_prop_ro("power_counter", &Safety::power_counter,
                   "Counter of power_protect(), 0 .. 10; the protection trips above 5.")
      .def_prop_ro(
          "position_motor", &Safety::position_motor,
          "SDK number of the first motor outside its range in the last position_protect(),\n"
          "or -1 if there was none.")
      .def_prop_ro("position_angle", &Safety::position_angle,
                   "Angle [rad] of position_motor, or 0 if there is none.")
      .def("reset", &Safety::reset,
           "Reset the counter and all results of earlier calls. Real-time: yes.");
}
