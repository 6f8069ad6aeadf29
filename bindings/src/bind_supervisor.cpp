// SPDX-License-Identifier: BSD-3-Clause
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <cctype>

#include "bindings.hpp"
#include "surefoot/supervisor.hpp"

namespace nb = nanobind;
using namespace nb::literals;
using namespace surefoot;

namespace {

constexpr double kUnlimited = std::numeric_limits<double>::infinity();

std::string to_upper(std::string name) {
  for (char& c : name) c = static_cast<char>(std::toupper(c));
  return name;
}

void bind_enums(nb::module_& m) {
  nb::enum_<Mode>(m, "Mode", "What a supervised robot is doing.")
      .value("PASSIVE", Mode::kPassive, "The motors damp.")
      .value("RISE", Mode::kRise, "On its way up from lying.")
      .value("STAND", Mode::kStand, "A StandController at work.")
      .value("SIT", Mode::kSit, "On its way down; also how a rise is aborted.")
      .value("DAMPING", Mode::kDamping, "The motors damp, latched: only arm() leads out.");
  nb::enum_<RiseStage>(m, "RiseStage",
                       "How far a rise is; in all but the last the body lies on the ground.")
      .value("HOLD_LEGS", RiseStage::kHoldLegs, "Legs hold themselves up where they are.")
      .value("FOLD", RiseStage::kFold, "They fold beside the body.")
      .value("WEIGH", RiseStage::kWeigh, "Hips outward: do the legs weigh what they should?")
      .value("PRESS", RiseStage::kPress, "The rear pair presses: does the nose go down?")
      .value("UP", RiseStage::kUp, "Over a crouch to the standing pose, or back down.");
  nb::enum_<Start>(m, "Start", "How a robot is when it is taken on.")
      .value("LYING", Start::kLying, "Motors damp; arming checks, arm(), then a rise.")
      .value("STANDING", Start::kStanding,
             "It stands already: taken over with its first good LowState, without checks.");
  nb::enum_<RequestStatus>(m, "RequestStatus",
                           "What became of a request; nothing moves for a refused one.")
      .value("ACCEPTED", RequestStatus::kAccepted, "The next update() takes it up.")
      .value("NO_STATE", RequestStatus::kNoState, "No valid LowState comes, or none has yet.")
      .value("NOT_ARMED", RequestStatus::kNotArmed, "arm() first.")
      .value("NOT_READY", RequestStatus::kNotReady, "An arming check fails, or passed too briefly.")
      .value("LATCHED", RequestStatus::kLatched, "Damping is latched: arm() first.")
      .value("OUT_OF_ORDER", RequestStatus::kOutOfOrder, "Not from this mode.")
      .value("BUSY", RequestStatus::kBusy,
             "Another request or a stop waits, or torques are fading.");
}

void bind_faults(nb::module_& m) {
  nb::enum_<FaultReaction>(m, "FaultReaction", "What is done about a fault.")
      .value("NONE", FaultReaction::kNone, "Nothing: there is no fault.")
      .value("WATCH", FaultReaction::kWatch, "It is said and counted.")
      .value("DEGRADE", FaultReaction::kDegrade, "The robot goes on with what is left.")
      .value(
          "SIT", FaultReaction::kSit,
          "It sits down, and stays so while the fault lasts; where only one that stands can tell,\n"
          "until arm().")
      .value("DAMP", FaultReaction::kDamp, "The motors brake, latched until arm().");
  nb::enum_<FaultId> id(m, "FaultId", "What can be wrong; fault_table() says more.");
  id.value("NONE", FaultId::kNone, "Nothing.");
  for (const FaultInfo& info : fault_table()) {
    id.value(to_upper(to_string(info.id)).c_str(), info.id, std::string(info.meaning).c_str());
  }
  nb::class_<FaultInfo>(m, "FaultInfo", "One row of fault_table().")
      .def_ro("id", &FaultInfo::id)
      .def_ro("reaction", &FaultInfo::reaction)
      .def_ro("detection_time", &FaultInfo::detection_time,
              "[s] from its begin to the reaction, at most.")
      .def_prop_ro("name", [](const FaultInfo& info) { return std::string(to_string(info.id)); })
      .def_prop_ro(
          "cleared_by", [](const FaultInfo& info) { return std::string(info.cleared_by); },
          "What ends the reaction, once the fault is no longer seen.")
      .def_prop_ro(
          "meaning", [](const FaultInfo& info) { return std::string(info.meaning); },
          "How it is seen and what is done, in a sentence.");
  m.def(
      "fault_table",
      [] { return std::vector<FaultInfo>(fault_table().begin(), fault_table().end()); },
      "Return every fault that a Supervisor tells, and its reaction.");
  nb::class_<FaultReport>(m, "FaultReport", "Which faults there are, and have been.")
      .def_prop_ro(
          "active",
          [](const FaultReport& report) {
            std::vector<FaultId> ids;
            for (const FaultInfo& info : fault_table()) {
              if (report.has(info.id)) ids.push_back(info.id);
            }
            return ids;
          },
          "Those there are.")
      .def(
          "count",
          [](const FaultReport& report, FaultId id) { return report.count[static_cast<int>(id)]; },
          "id"_a, "Return how often a fault has begun.")
      .def(
          "motor",
          [](const FaultReport& report, FaultId id) { return report.motor[static_cast<int>(id)]; },
          "id"_a, "Return the SDK number of the motor it was last seen at, or -1.")
      .def_ro("last", &FaultReport::last, "The fault that began last.");
}

void bind_arming(nb::module_& m) {
  nb::class_<ArmingCheck>(m, "ArmingCheck", "One arming check: what was found.")
      .def_ro("applies", &ArmingCheck::applies, "False: nothing to judge; counts as passed.")
      .def_ro("passed", &ArmingCheck::passed)
      .def_ro("value", &ArmingCheck::value, "The worst that was found; unit in the text.")
      .def_ro("limit", &ArmingCheck::limit, "What it was held against.")
      .def_ro("motor", &ArmingCheck::motor, "SDK number of the motor found at, or -1.")
      .def_ro("swapped_with", &ArmingCheck::swapped_with, "Motor it seems swapped with, or -1.");
  nb::class_<ArmingReport>(m, "ArmingReport", "All arming checks of one tick.")
      .def_ro("passed_for", &ArmingReport::passed_for, "[s] that all have passed without a break.")
      .def_ro("ready", &ArmingReport::ready, "Have they for the time that arming asks for?")
      .def_prop_ro(
          "checks",
          [](const ArmingReport& report) {
            nb::typed<nb::dict, nb::str, ArmingCheck> checks;
            for (int i = 0; i < kArmingChecks; ++i) {
              checks[to_string(static_cast<ArmingCheckId>(i))] = report.checks[i];
            }
            return checks;
          },
          "By name: link, motor_mode, temperature, quaternion, gyroscope, accelerometer, attitude, "
          "tilt, joints, motor_order, foot_force, program, fault.")
      .def(
          "failures",
          [](const ArmingReport& report, const Robot& robot) {
            return describe_failures(report, robot.config());
          },
          "robot"_a, "Return a sentence for every check that failed, one a line.");
}

void bind_supervisor_class(nb::module_& m) {
  nb::class_<SupervisorOptions>(m, "SupervisorOptions", "What is set once for a Supervisor.")
      .def(
          "__init__",
          [](SupervisorOptions* self, int power_level, double arming_time,
             double temperature_warning, double temperature_stop, double battery_low,
             double payload_limit, double operator_timeout, double joint_margin,
             const StandOptions& stand, Start start, bool remote) {
            new (self) SupervisorOptions{power_level,
                                         arming_time,
                                         temperature_warning,
                                         temperature_stop,
                                         battery_low,
                                         payload_limit,
                                         operator_timeout,
                                         joint_margin,
                                         stand,
                                         start,
                                         remote};
          },
          nb::kw_only(), "power_level"_a = 1, "arming_time"_a = 1.0, "temperature_warning"_a = 60.0,
          "temperature_stop"_a = 80.0, "battery_low"_a = 10.0, "payload_limit"_a = kUnlimited,
          "operator_timeout"_a = kUnlimited, "joint_margin"_a = -0.15, "stand"_a = StandOptions(),
          "start"_a = Start::kLying, "remote"_a = true)
      .def_rw("power_level", &SupervisorOptions::power_level,
              "1 .. 10, of power_protect(), 100 W each. Plans keep below it, stand.power_limit is\n"
              "0.9 of it or less. 0: off, and that limit with it; plans keep below 1.")
      .def_rw("arming_time", &SupervisorOptions::arming_time, "[s] that all checks must pass.")
      .def_rw("temperature_warning", &SupervisorOptions::temperature_warning,
              "[deg C] torque limits fall from here on ...")
      .def_rw("temperature_stop", &SupervisorOptions::temperature_stop,
              "[deg C] ... to half, where the robot sits down.")
      .def_rw("battery_low", &SupervisorOptions::battery_low,
              "[%] of charge, below which it sits down.")
      .def_rw("payload_limit", &SupervisorOptions::payload_limit,
              "[kg] that it may bear before it sits down.")
      .def_rw("operator_timeout", &SupervisorOptions::operator_timeout,
              "[s] without heartbeat() before it sits down.")
      .def_rw("joint_margin", &SupervisorOptions::joint_margin,
              "[rad] kept from the limits for arming; negative: beyond.")
      .def_rw("stand", &SupervisorOptions::stand, "Of the StandController.")
      .def_rw("start", &SupervisorOptions::start)
      .def_rw("remote", &SupervisorOptions::remote, "B on the remote stops.");
  nb::class_<Supervisor>(m, "Supervisor",
                         "Takes a robot from lying to standing and back, behind arming, refusals "
                         "and a stop.\n\n"
                         "request(), arm() and stop() may be called from any thread; update() "
                         "belongs to one.")
      .def(
          "__init__",
          [](Supervisor* self, const Robot& robot, const Gains* gains,
             const SupervisorOptions& options) {
            new (self) Supervisor(robot, gains ? *gains : robot.config().gains, options);
          },
          "robot"_a, "gains"_a = nb::none(), "options"_a = SupervisorOptions(),
          "Raise Error: not twelve joints, an invalid gain or option.")
      .def(
          "update", [](Supervisor& s, const LowState& state) { return LowCmd(s.update(state)); },
          "low_state"_a, "Compute one tick: LowState in, a copy of the LowCmd out.")
      .def(
          "update_without_state",
          [](Supervisor& s, double age) { return LowCmd(s.update_without_state(age)); }, "age"_a,
          "Go on without a LowState, the newest `age` seconds old: a copy of the LowCmd.\n\n"
          "The last command while it is no older than 10 ms, then damping; after 20 ms requests "
          "are "
          "refused until update() is called again. Negative or NaN is too old. Nothing latches and "
          "no fault is told but what stop() asks for: call lose() once the robot has been silent "
          "for too long (surefoot run: 20 ms).")
      .def("report_link_lost", &Supervisor::report_link_lost,
           "The robot is not heard: latch, if armed.")
      .def("count_samples", &Supervisor::count_samples, "received"_a, "missing"_a,
           "Say what the link has counted since the last call, for the arming check.")
      .def("request", &Supervisor::request, "mode"_a,
           "Ask for RISE (from PASSIVE), SIT (from RISE and STAND) or STAND (from SIT).")
      .def("arm", &Supervisor::arm, "Allow requests, and leave latched damping.")
      .def("stop", &Supervisor::stop, "Damp at once and latch, whatever the mode.")
      .def("heartbeat", &Supervisor::heartbeat, "Say that the operator is there.")
      .def_prop_ro("mode", &Supervisor::mode)
      .def_prop_ro("armed", &Supervisor::armed)
      .def_prop_ro("damping_fault", &Supervisor::damping_fault, "Why the damping latched last.")
      .def_prop_ro("faults", &Supervisor::faults, "Which faults there are: a copy.")
      .def_prop_ro("arming", &Supervisor::arming, "Every check of the last tick: a copy.")
      .def_prop_ro("rise_progress", &Supervisor::rise_progress,
                   "Way from lying (0) to standing (1).")
      .def_prop_ro("rise_time", &Supervisor::rise_time, "[s] from legs folded to standing.")
      .def_prop_ro("fading", &Supervisor::fading, "Are torques on their way from mode to mode?")
      .def_prop_ro("rise_failed", &Supervisor::rise_failed, "Did the last rise give up?")
      .def_prop_ro("rise_stage", &Supervisor::rise_stage, "Of the last rise, or of this.")
      .def_prop_ro("command_is_fresh", &Supervisor::command_is_fresh,
                   "Was the last command made from its LowState?")
      .def_prop_ro("measured_power", &Supervisor::measured_power,
                   "[W] that the power protection judged last; 0 while it has nothing to judge.")
      .def("set_gains", &Supervisor::set_gains, "gains"_a, "As StandController's; raise Error.")
      .def("set_body_reference", &Supervisor::set_body_reference, "target"_a,
           "Ask for another pose of the body while standing.")
      .def_prop_ro("stand_controller", &Supervisor::stand_controller,
                   nb::rv_policy::reference_internal, "The StandController, to look at.");
}

}  // namespace

void bind_supervisor(nb::module_& m) {
  bind_enums(m);
  bind_faults(m);
  bind_arming(m);
  bind_supervisor_class(m);
}
