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
  nb::enum_<Mode>(m, "Mode", "State of a supervised robot.")
      .value("PASSIVE", Mode::kPassive,
             "The motors damp; the first mode, and the one after sitting down.")
      .value("RISE", Mode::kRise, "The robot rises from lying to standing.")
      .value("STAND", Mode::kStand, "The StandController is in control.")
      .value("SIT", Mode::kSit, "The robot sits down; also the way to abort a rise.")
      .value("DAMPING", Mode::kDamping, "The motors damp, latched: only arm() leaves this mode.");
  nb::enum_<RiseStage>(m, "RiseStage",
                       "Stage of a rise. In all stages but UP the body lies on the ground.")
      .value("HOLD_LEGS", RiseStage::kHoldLegs, "The legs hold their own weight where they are.")
      .value("FOLD", RiseStage::kFold, "The legs fold beside the body.")
      .value("WEIGH", RiseStage::kWeigh,
             "The hips turn outward: their torques must fit the weight of the legs.")
      .value("PRESS", RiseStage::kPress,
             "The rear legs press on the ground: the nose must go down.")
      .value("UP", RiseStage::kUp,
             "From folded legs over a crouch to the standing pose, or back down.");
  nb::enum_<Start>(m, "Start", "State of the robot when the supervisor takes it over.")
      .value("LYING", Start::kLying, "The motors damp: arming checks, arm(), then a rise.")
      .value("STANDING", Start::kStanding,
             "The robot already stands under another controller and would sink during any\n"
             "pause.\n\n"
             "The supervisor takes it over with the first valid LowState, without arming\n"
             "checks. After latched damping, arm() takes over the pose in which it finds the\n"
             "robot, again without checks.");
  nb::enum_<RequestStatus>(
      m, "RequestStatus",
      "Answer to a request. For any status but ACCEPTED the request has no effect.")
      .value("ACCEPTED", RequestStatus::kAccepted, "The next update() handles the request.")
      .value("NO_STATE", RequestStatus::kNoState,
             "No valid LowState arrives, or none has arrived yet.")
      .value("NOT_ARMED", RequestStatus::kNotArmed, "The robot is not armed: call arm() first.")
      .value("NOT_READY", RequestStatus::kNotReady,
             "An arming check fails or passed too briefly, see arming; or a fault is active.")
      .value("LATCHED", RequestStatus::kLatched, "Damping is latched: call arm() first.")
      .value("OUT_OF_ORDER", RequestStatus::kOutOfOrder,
             "Not possible from this mode: RISE from PASSIVE, SIT from RISE and STAND, ...")
      .value("BUSY", RequestStatus::kBusy,
             "Another request or a stop is pending, or torques fade between two modes.");
}

void bind_faults(nb::module_& m) {
  nb::enum_<FaultReaction>(m, "FaultReaction", "What the supervisor does about a fault.")
      .value("NONE", FaultReaction::kNone, "Nothing: there is no fault.")
      .value("WATCH", FaultReaction::kWatch,
             "The fault is reported and counted; the robot goes on.")
      .value("DEGRADE", FaultReaction::kDegrade,
             "The robot goes on with the sensors, contacts or legs that are left.")
      .value("SIT", FaultReaction::kSit,
             "The robot sits down and does not rise while the fault lasts.\n\n"
             "Where only a standing robot can detect the fault, it does not rise before arm().")
      .value("DAMP", FaultReaction::kDamp, "The motors brake, latched until arm().");
  nb::enum_<FaultId> id(
      m, "FaultId",
      "Faults of a supervised robot and of the link to it; fault_table() explains them.");
  id.value("NONE", FaultId::kNone, "Nothing.");
  for (const FaultInfo& info : fault_table()) {
    id.value(to_upper(to_string(info.id)).c_str(), info.id, std::string(info.meaning).c_str());
  }
  nb::class_<FaultInfo>(m, "FaultInfo",
                        "One row of fault_table(): id is the FaultId, name its text, reaction the\n"
                        "FaultReaction.")
      .def_ro("id", &FaultInfo::id)
      .def_ro("reaction", &FaultInfo::reaction)
      .def_ro("detection_time", &FaultInfo::detection_time,
              "Longest time from the onset of the fault to the reaction [s].")
      .def_prop_ro("name", [](const FaultInfo& info) { return std::string(to_string(info.id)); })
      .def_prop_ro(
          "cleared_by", [](const FaultInfo& info) { return std::string(info.cleared_by); },
          "What ends the reaction once the fault is gone.")
      .def_prop_ro(
          "meaning", [](const FaultInfo& info) { return std::string(info.meaning); },
          "How the fault is detected and what is done, in a sentence.");
  m.def(
      "fault_table",
      [] { return std::vector<FaultInfo>(fault_table().begin(), fault_table().end()); },
      "Return a FaultInfo for every fault of a Supervisor, in the order of FaultId.");
  nb::class_<FaultReport>(m, "FaultReport", "Active and past faults of a Supervisor.")
      .def_prop_ro(
          "active",
          [](const FaultReport& report) {
            std::vector<FaultId> ids;
            for (const FaultInfo& info : fault_table()) {
              if (report.has(info.id)) ids.push_back(info.id);
            }
            return ids;
          },
          "FaultIds of the active faults, in the order of FaultId.")
      .def(
          "count",
          [](const FaultReport& report, FaultId id) { return report.count[static_cast<int>(id)]; },
          "id"_a, "Return how often a fault has begun.")
      .def(
          "motor",
          [](const FaultReport& report, FaultId id) { return report.motor[static_cast<int>(id)]; },
          "id"_a, "Return the SDK number of the motor that last had the fault, or -1.")
      .def_ro("last", &FaultReport::last, "Fault that began last.");
}

void bind_arming(nb::module_& m) {
  nb::class_<ArmingCheck>(m, "ArmingCheck",
                          "Result of one arming check; passed is true if it passed.")
      .def_ro("applies", &ArmingCheck::applies,
              "False: the check does not apply now, and counts as passed.")
      .def_ro("passed", &ArmingCheck::passed)
      .def_ro("value", &ArmingCheck::value,
              "Worst value found; ArmingReport.failures() gives its unit.")
      .def_ro("limit", &ArmingCheck::limit,
              "Limit that the value is compared with, in the same unit.")
      .def_ro("motor", &ArmingCheck::motor, "SDK number of the motor with the worst value, or -1.")
      .def_ro("swapped_with", &ArmingCheck::swapped_with,
              "SDK number of the motor that motor seems swapped with, or -1.");
  nb::class_<ArmingReport>(m, "ArmingReport", "Results of all arming checks of one tick.")
      .def_ro("passed_for", &ArmingReport::passed_for,
              "Time for which all checks have passed without interruption [s].")
      .def_ro("ready", &ArmingReport::ready,
              "True if passed_for has reached SupervisorOptions.arming_time.")
      .def_prop_ro(
          "checks",
          [](const ArmingReport& report) {
            nb::typed<nb::dict, nb::str, ArmingCheck> checks;
            for (int i = 0; i < kArmingChecks; ++i) {
              checks[to_string(static_cast<ArmingCheckId>(i))] = report.checks[i];
            }
            return checks;
          },
          "ArmingCheck by name:\n\n"
          "- link: LowStates arrive, the newest is new, and less than 1 % of them is\n"
          "  missing\n"
          "- motor_mode: all twelve motors report servo mode\n"
          "- temperature: all twelve motors are below SupervisorOptions.temperature_warning\n"
          "- quaternion: the IMU quaternion has unit length\n"
          "- gyroscope: the body does not rotate\n"
          "- accelerometer: the specific force has the magnitude of gravity\n"
          "- attitude: quaternion and accelerometer agree about the vertical; not about\n"
          "  heading\n"
          "- tilt: the body is nearly level\n"
          "- joints: all joints are within their limits and SupervisorOptions.joint_margin\n"
          "- motor_order: every joint angle fits the range of its own motor\n"
          "- foot_force: footForceEst adds up to the weight; applies to a standing robot\n"
          "  only\n"
          "- program: the torques that hold the robot on its way up are below their limits\n"
          "- fault: no active fault keeps the robot down")
      .def(
          "failures",
          [](const ArmingReport& report, const Robot& robot) {
            return describe_failures(report, robot.config());
          },
          "robot"_a, "Describe all failed checks, one sentence a line; empty if no check failed.");
}

void bind_supervisor_class(nb::module_& m) {
  nb::class_<SupervisorOptions>(
      m, "SupervisorOptions",
      "Options of a Supervisor: fixed at construction, unlike gains.\n\n"
      "start is the state of the robot at the first sample. Supervisor() raises Error\n"
      "if an option is out of range.")
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
              "Level of Safety.power_protect(), 1 .. 10, which trips at 100 W times the level.\n\n"
              "Rising and sitting down are planned for half of it; while standing,\n"
              "stand.power_limit is at most 0.9 of it. 0 switches the protection and this power\n"
              "limit off; motions are then planned for level 1.")
      .def_rw("arming_time", &SupervisorOptions::arming_time,
              "Time for which all arming checks must have passed [s].")
      .def_rw("temperature_warning", &SupervisorOptions::temperature_warning,
              "Motor temperature where torque limits start to fall [deg C].")
      .def_rw("temperature_stop", &SupervisorOptions::temperature_stop,
              "Motor temperature where torque limits are halved and the robot sits down [deg\n"
              "C].")
      .def_rw("battery_low", &SupervisorOptions::battery_low,
              "Charge below which the robot sits down [%].")
      .def_rw("payload_limit", &SupervisorOptions::payload_limit,
              "Payload above which the robot sits down [kg]; inf: no limit.")
      .def_rw("operator_timeout", &SupervisorOptions::operator_timeout,
              "Time without heartbeat() after which the robot sits down [s]; inf needs no\n"
              "operator.")
      .def_rw("joint_margin", &SupervisorOptions::joint_margin,
              "Distance that joints must keep from their limits [rad], for arming and for the\n"
              "fault joint_stop.\n\n"
              "Negative: how far beyond the limits they may be. A fully folded calf rests on\n"
              "its stop, beyond the limits.")
      .def_rw("stand", &SupervisorOptions::stand, "Options of the StandController.")
      .def_rw("start", &SupervisorOptions::start)
      .def_rw("remote", &SupervisorOptions::remote,
              "True: button B on the remote stops the robot.");
  nb::class_<Supervisor>(
      m, "Supervisor",
      "Controller that takes a robot from lying to standing and back: LowState in,\n"
      "LowCmd out.\n\n"
      "It checks the robot before it arms, refuses requests that do not fit, detects\n"
      "faults, and stops on request. mode is the present Mode, armed is true if the\n"
      "robot is armed.\n\n"
      "Rising. First the legs fold from any pose, feet beside the body and knees up.\n"
      "Then they move over a crouch to the standing pose. All legs move alike, so the\n"
      "feet stay in place while the body comes over them and up. A leg that is blocked\n"
      "backs out and tries again, up to eight times. If the body rolls over its legs,\n"
      "they are released, at most twice. A robot that already crouches or stands, with\n"
      "all joints within 0.35 rad of this path, rises from there without folding.\n"
      "Before the body leaves the ground, the folded legs are weighed and the rear legs\n"
      "press on the ground, which detects the faults wiring and wrong_robot. The speed\n"
      "is limited so that the torques that hold the robot take half of the power level.\n"
      "Sitting down follows the same path backwards.\n\n"
      "Torques fade between modes within 0.25 s; damping after a stop or a fault comes\n"
      "at once. fault_table() lists the faults and the reactions to them.\n\n"
      "Threads: update(), update_without_state(), report_link_lost(), count_samples(),\n"
      "set_gains(), set_body_reference(), stand_controller, command_is_fresh and\n"
      "measured_power belong to one thread. All other functions may be called from any\n"
      "thread. No function takes a lock.")
      .def(
          "__init__",
          [](Supervisor* self, const Robot& robot, const Gains* gains,
             const SupervisorOptions& options) {
            new (self) Supervisor(robot, gains ? *gains : robot.config().gains, options);
          },
          "robot"_a, "gains"_a = nb::none(), "options"_a = SupervisorOptions(),
          "Create a supervisor.\n\n"
          "Args:\n"
          "    robot: Model and configuration, twelve joints on a free base.\n"
          "    gains: None: those of robot.config.\n"
          "    options: Fixed at construction.\n\n"
          "Raises:\n"
          "    Error: The robot does not have twelve joints on a free base, or a gain or an\n"
          "        option is invalid.")
      .def(
          "update", [](Supervisor& s, const LowState& state) { return LowCmd(s.update(state)); },
          "low_state"_a,
          "Compute one tick. Never raises. Real-time: yes.\n\n"
          "Args:\n"
          "    low_state: Newest sample.\n\n"
          "Returns:\n"
          "    The command to send, a copy.")
      .def(
          "update_without_state",
          [](Supervisor& s, double age) { return LowCmd(s.update_without_state(age)); }, "age"_a,
          "Compute the command of a period without a new LowState.\n\n"
          "The last command while it is at most 10 ms old, then damping. After 20 ms\n"
          "requests are refused until update() is called again. Nothing latches except on\n"
          "stop(): call report_link_lost() once the robot has been silent for too long\n"
          "(surefoot run: 20 ms). Real-time: yes.\n\n"
          "Args:\n"
          "    age: Age of the newest LowState [s], measured by the caller; negative or\n"
          "        NaN: too old.\n\n"
          "Returns:\n"
          "    The command to send, a copy.")
      .def("report_link_lost", &Supervisor::report_link_lost,
           "Report that no LowState arrived for too long, or that the robot restarted.\n\n"
           "If the robot is armed, damping latches with the fault link. Pending requests are\n"
           "dropped. Real-time: yes.")
      .def("count_samples", &Supervisor::count_samples, "received"_a, "missing"_a,
           "Report how many LowStates the link received and missed since the last call.\n\n"
           "For the arming check link. The link receives more samples than update()\n"
           "processes, and its count replaces the count of update(). The caller must then\n"
           "judge gaps itself and call report_link_lost(). Real-time: yes.\n\n"
           "Args:\n"
           "    received: Number of LowStates.\n"
           "    missing: Number of LowStates; negative if some arrived late after all.")
      .def("request", &Supervisor::request, "mode"_a,
           "Request a mode; any thread. Real-time: yes.\n\n"
           "RISE from PASSIVE; SIT from RISE and STAND; STAND from SIT, to rise again.\n"
           "Returns the RequestStatus.")
      .def("arm", &Supervisor::arm,
           "Arm the robot: allow requests, and leave latched damping for PASSIVE.\n\n"
           "A lost leg is used again. Any thread. Real-time: yes. Returns the RequestStatus.")
      .def("stop", &Supervisor::stop,
           "Damp at once and latch, in any mode. Any thread, also repeatedly. Real-time:\n"
           "yes.")
      .def("heartbeat", &Supervisor::heartbeat,
           "Signal that the operator is present, see SupervisorOptions.operator_timeout.\n\n"
           "Any thread. Real-time: yes.")
      .def_prop_ro("mode", &Supervisor::mode)
      .def_prop_ro("armed", &Supervisor::armed)
      .def_prop_ro("damping_fault", &Supervisor::damping_fault,
                   "Why damping last latched; NONE after arm().")
      .def_prop_ro("faults", &Supervisor::faults,
                   "Consistent copy of the active and past faults of the last tick.")
      .def_prop_ro("arming", &Supervisor::arming,
                   "Consistent copy of the arming checks of the last tick.")
      .def_prop_ro("rise_progress", &Supervisor::rise_progress,
                   "Commanded position on the path from lying (0) to standing (1).\n\n"
                   "0 before the body rises and in PASSIVE and DAMPING.")
      .def_prop_ro("rise_time", &Supervisor::rise_time,
                   "Planned time from folded legs to standing [s].")
      .def_prop_ro("fading", &Supervisor::fading,
                   "True while torques fade from one mode to the next.")
      .def_prop_ro(
          "rise_failed", &Supervisor::rise_failed,
          "True if the last rise gave up: a leg could not fold, or the body did not follow.")
      .def_prop_ro("rise_stage", &Supervisor::rise_stage,
                   "Stage of the present rise, or of the last one.")
      .def_prop_ro("command_is_fresh", &Supervisor::command_is_fresh,
                   "True if the last command was computed from the newest LowState.")
      .def_prop_ro("measured_power", &Supervisor::measured_power,
                   "Power that the power protection last judged [W].\n\n"
                   "0 while it is off or no torques are applied.")
      .def("set_gains", &Supervisor::set_gains, "gains"_a,
           "Set the gains, see StandController.set_gains().\n\n"
           "fold_wait takes effect when the legs next begin to fold. Raises Error and\n"
           "changes nothing if a gain is invalid. Real-time: no.")
      .def("set_body_reference", &Supervisor::set_body_reference, "target"_a,
           "Set the target pose of the body while standing, see\n"
           "StandController.set_body_reference().")
      .def_prop_ro("stand_controller", &Supervisor::stand_controller,
                   nb::rv_policy::reference_internal,
                   "The StandController, a reference for reading only.");
}

}  // namespace

void bind_supervisor(nb::module_& m) {
  bind_enums(m);
  bind_faults(m);
  bind_arming(m);
  bind_supervisor_class(m);
}
