// SPDX-License-Identifier: BSD-3-Clause
#include <nanobind/stl/array.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <cctype>

#include "bindings.hpp"
#include "surefoot/supervisor.hpp"
#include "value_class.hpp"

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
             "The motors damp. This is the first mode, and the mode after sitting down.")
      .value("RISE", Mode::kRise, "The robot rises from lying to standing.")
      .value("STAND", Mode::kStand, "The robot stands, and steps only to keep its balance.")
      .value("WALK", Mode::kWalk,
             "The robot follows Supervisor.set_velocity(); at velocity 0 it stands.")
      .value("SIT", Mode::kSit, "The robot sits down. Request this mode also to abort a rise.")
      .value("DAMPING", Mode::kDamping,
             "The motors damp until arm(), the only way to leave this mode.");
  nb::enum_<RiseStage>(m, "RiseStage",
                       "Stage of a rise. In all stages but UP the body lies on the ground.")
      .value("HOLD_LEGS", RiseStage::kHoldLegs, "The legs hold their own weight where they are.")
      .value("FOLD", RiseStage::kFold, "The legs fold beside the body.")
      .value("WEIGH", RiseStage::kWeigh,
             "The hips turn outward. This is a check.\n\n"
             "Hip torques that do not match the weight of the legs are the fault WIRING or\n"
             "WRONG_ROBOT.")
      .value("PRESS", RiseStage::kPress,
             "The rear legs press on the ground. This is a check.\n\n"
             "If the front of the trunk does not go down, the fault is WIRING.")
      .value("UP", RiseStage::kUp,
             "The legs move from the folded pose through a crouch to the standing pose, or\n"
             "back.");
  nb::enum_<Start>(m, "Start", "State of the robot when the supervisor takes it over.")
      .value("LYING", Start::kLying,
             "The robot lies and its motors damp.\n\n"
             "The robot must pass the arming checks, then arm() must be called, then the robot\n"
             "may rise.")
      .value("STANDING", Start::kStanding,
             "The robot already stands under another controller, and would sink if torques\n"
             "paused.\n\n"
             "The supervisor takes it over with the first valid LowState, without arming\n"
             "checks. After latched damping, arm() takes over the pose in which it finds the\n"
             "robot, again without checks.");
  nb::enum_<RequestStatus>(
      m, "RequestStatus",
      "Answer to a request. For any status but ACCEPTED the request has no effect.")
      .value("ACCEPTED", RequestStatus::kAccepted, "The next update() handles the request.")
      .value("NO_STATE", RequestStatus::kNoState,
             "No valid LowState has arrived, or they no longer arrive.")
      .value("NOT_ARMED", RequestStatus::kNotArmed, "The robot is not armed; call arm() first.")
      .value("NOT_READY", RequestStatus::kNotReady,
             "An arming check fails, or has not passed for SupervisorOptions.arming_time yet,\n"
             "or a fault keeps the robot down; see Supervisor.arming. For WALK: a fault that\n"
             "makes a walking robot stop is active; see Supervisor.faults.")
      .value("LATCHED", RequestStatus::kLatched, "Damping is latched; call arm() first.")
      .value("OUT_OF_ORDER", RequestStatus::kOutOfOrder,
             "The present mode does not allow this request, see Supervisor.request().")
      .value("BUSY", RequestStatus::kBusy,
             "Another request or a stop is pending, torques fade between two modes, or the robot\n"
             "stops walking.")
      .value("CANNOT_WALK", RequestStatus::kCannotWalk,
             "The motors cannot carry the robot on two feet, see WalkController.can_walk.");
}

void bind_faults(nb::module_& m) {
  nb::enum_<FaultReaction>(m, "FaultReaction", "What the supervisor does about a fault.")
      .value("NONE", FaultReaction::kNone, "Nothing, because there is no fault.")
      .value("WATCH", FaultReaction::kWatch,
             "The fault is reported and counted; the robot continues.")
      .value("DEGRADE", FaultReaction::kDegrade,
             "The robot continues with the remaining sensors, contacts or legs.")
      .value("SIT", FaultReaction::kSit,
             "The robot sits down and does not rise while the fault lasts.\n\n"
             "A robot that walks stops on four feet first, within 1.5 s.\n\n"
             "If only a standing robot can detect the fault, the robot does not rise again\n"
             "until arm() is called.")
      .value("DAMP", FaultReaction::kDamp, "The motors damp until arm().");
  nb::enum_<FaultId> id(
      m, "FaultId",
      "Faults of a supervised robot and of the link to it; fault_table() explains them.");
  id.value("NONE", FaultId::kNone, "No fault.");
  for (const FaultInfo& info : fault_table()) {
    id.value(to_upper(to_string(info.id)).c_str(), info.id, std::string(info.meaning).c_str());
  }
  nb::class_<FaultInfo>(m, "FaultInfo", "One row of fault_table().")
      .def_ro("id", &FaultInfo::id, "FaultId of the fault.")
      .def_ro("reaction", &FaultInfo::reaction, "What the supervisor does about the fault.")
      .def_ro("detection_time", &FaultInfo::detection_time,
              "Longest time from the onset of the fault to the reaction [s].")
      .def_prop_ro(
          "name", [](const FaultInfo& info) { return std::string(to_string(info.id)); },
          "Name of the fault, such as 'motor_weak'.")
      .def_prop_ro(
          "cleared_by", [](const FaultInfo& info) { return std::string(info.cleared_by); },
          "What ends the reaction after the fault has ended.")
      .def_prop_ro(
          "meaning", [](const FaultInfo& info) { return std::string(info.meaning); },
          "How the fault is detected and how the supervisor reacts, a sentence.")
      .def_prop_ro(
          "while_stepping", [](const FaultInfo& info) { return std::string(info.while_stepping); },
          "What differs while the feet step; empty: nothing.")
      .def_prop_ro(
          "stepping_detection_time",
          [](const FaultInfo& info) {
            return info.stepping_detection_time > 0.0 ? info.stepping_detection_time
                                                      : info.detection_time;
          },
          "detection_time while the feet step [s].")
      .def_ro("stops_walking", &FaultInfo::stops_walking,
              "True if a robot that walks stops and stands, and WALK is refused.")
      .def("__repr__", [](const FaultInfo& info) {
        return "FaultInfo(name='" + std::string(to_string(info.id)) + "', reaction='" +
               to_string(info.reaction) + "')";
      });
  m.def(
      "fault_table",
      [] { return std::vector<FaultInfo>(fault_table().begin(), fault_table().end()); },
      "Return a FaultInfo for every fault of a Supervisor, in the order of FaultId.");
  ValueClass<FaultReport>(m, "FaultReport", "Active and past faults of a Supervisor.")
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
          "id"_a, "Return the number of times that a fault has begun.")
      .def(
          "motor",
          [](const FaultReport& report, FaultId id) { return report.motor[static_cast<int>(id)]; },
          "id"_a, "Return the SDK number of the motor that last had the fault, or -1.")
      .def_ro("last", &FaultReport::last, "Fault that began last.")
      .def_part(
          "faults",
          [](nb::handle self) -> nb::object {
            const auto& report = nb::cast<const FaultReport&>(self);
            return nb::make_tuple(report.active, report.count, report.motor);
          },
          [](nb::handle self, nb::handle saved) {
            auto& report = nb::cast<FaultReport&>(self);
            report.active = nb::cast<decltype(report.active)>(saved[0]);
            report.count = nb::cast<decltype(report.count)>(saved[1]);
            report.motor = nb::cast<decltype(report.motor)>(saved[2]);
          })
      .def_repr([](const FaultReport& report) {
        std::string active, count;
        for (const FaultInfo& info : fault_table()) {
          const std::string name = to_string(info.id);
          const std::uint32_t times = report.count[static_cast<int>(info.id)];
          const int motor = report.motor[static_cast<int>(info.id)];
          if (report.has(info.id)) active += (active.empty() ? "" : ", ") + name;
          if (times == 0) continue;
          count += (count.empty() ? "" : ", ") + name + ": " + std::to_string(times);
          if (motor >= 0) count += " (last at motor " + std::to_string(motor) + ")";
        }
        return "FaultReport(active=[" + active + "], count={" + count +
               "}, last=" + to_string(report.last) + ")";
      });
}

void bind_arming(nb::module_& m) {
  ValueClass<ArmingCheck>(m, "ArmingCheck", "Result of one arming check.")
      .def_ro("applies", &ArmingCheck::applies,
              "False if the check does not apply now and counts as passed.")
      .def_ro("passed", &ArmingCheck::passed, "True if the value is within the limit.")
      .def_ro("value", &ArmingCheck::value,
              "Worst value found; ArmingReport.failures() gives its unit.")
      .def_ro("limit", &ArmingCheck::limit,
              "Limit that the value is compared with, in the same unit.")
      .def_ro("motor", &ArmingCheck::motor, "SDK number of the motor with the worst value, or -1.")
      .def_ro("swapped_with", &ArmingCheck::swapped_with,
              "SDK number of the second motor if `motor` seems swapped with another; else -1.");
  ValueClass<ArmingReport>(m, "ArmingReport", "Results of all arming checks of one tick.")
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
          "Results of the checks, a dictionary of ArmingCheck by name.\n\n"
          "- link: LowStates arrive, this tick has a new one, and fewer than 1 % are\n"
          "  missing\n"
          "- motor_mode: all twelve motors report servo mode\n"
          "- temperature: all twelve motors are below SupervisorOptions.temperature_warning\n"
          "- quaternion: the IMU quaternion has unit length\n"
          "- gyroscope: the body does not rotate\n"
          "- accelerometer: the specific force has the magnitude of gravity\n"
          "- attitude: quaternion and accelerometer agree about the vertical (heading is\n"
          "  not checked)\n"
          "- tilt: the body is nearly level\n"
          "- joints: all joints keep SupervisorOptions.joint_margin from their limits\n"
          "- motor_order: every joint angle fits the range of its own motor; else motors\n"
          "  are swapped\n"
          "- foot_force: the sum of footForceEst is the weight; applies only to a standing\n"
          "  robot with footForceEst\n"
          "- program: the torques that hold the robot during a rise are below their limits\n"
          "- fault: no active fault keeps the robot down\n"
          "- conflict: no other program commands the robot, and no second robot sends\n"
          "  LowStates; only over DDS")
      .def(
          "failures",
          [](const ArmingReport& report, const Robot& robot) {
            return describe_failures(report, robot.config());
          },
          "robot"_a, "Describe all failed checks, one sentence per line; empty if no check failed.")
      .def_part(
          "results",
          [](nb::handle self) { return nb::cast(nb::cast<const ArmingReport&>(self).checks); },
          [](nb::handle self, nb::handle saved) {
            auto& report = nb::cast<ArmingReport&>(self);
            report.checks = nb::cast<decltype(report.checks)>(saved);
          })
      .def_repr([](const ArmingReport& report) {
        std::string failed;
        for (int i = 0; i < kArmingChecks; ++i) {
          const ArmingCheck& check = report.checks[i];
          if (!check.applies || check.passed) continue;
          failed += (failed.empty() ? "" : ", ") +
                    std::string(to_string(static_cast<ArmingCheckId>(i))) + ": " +
                    nb::repr(nb::cast(check)).c_str();
        }
        return "ArmingReport(ready=" + std::string(report.ready ? "True" : "False") +
               ", passed_for=" + value_text(nb::float_(report.passed_for)) + ", failed={" + failed +
               "})";
      });
}

void bind_supervisor_class(nb::module_& m) {
  ValueClass<SupervisorOptions>(m, "SupervisorOptions",
                                "Options of a Supervisor: fixed at construction, unlike gains.\n\n"
                                "Supervisor() raises Error if an option is out of range.")
      .def(
          "__init__",
          [](SupervisorOptions* self, FieldArgument<int> power_level,
             FieldArgument<double> arming_time, FieldArgument<double> temperature_warning,
             FieldArgument<double> temperature_stop, FieldArgument<double> battery_low,
             FieldArgument<double> payload_limit, FieldArgument<double> operator_timeout,
             FieldArgument<double> joint_margin, FieldArgument<ControllerOptions> stand,
             FieldArgument<double> velocity_timeout, FieldArgument<Start> start,
             FieldArgument<bool> remote) {
            constexpr const char* kType = "SupervisorOptions";
            new (self) SupervisorOptions{power_level.to(kType, "power_level"),
                                         arming_time.to(kType, "arming_time"),
                                         temperature_warning.to(kType, "temperature_warning"),
                                         temperature_stop.to(kType, "temperature_stop"),
                                         battery_low.to(kType, "battery_low"),
                                         payload_limit.to(kType, "payload_limit"),
                                         operator_timeout.to(kType, "operator_timeout"),
                                         joint_margin.to(kType, "joint_margin"),
                                         stand.to(kType, "stand"),
                                         velocity_timeout.to(kType, "velocity_timeout"),
                                         start.to(kType, "start"),
                                         remote.to(kType, "remote")};
          },
          nb::kw_only(), "power_level"_a = 1, "arming_time"_a = 1.0, "temperature_warning"_a = 60.0,
          "temperature_stop"_a = 80.0, "battery_low"_a = 10.0, "payload_limit"_a = kUnlimited,
          "operator_timeout"_a = kUnlimited, "joint_margin"_a = -0.15,
          "stand"_a = ControllerOptions(),
          "velocity_timeout"_a = SupervisorOptions().velocity_timeout, "start"_a = Start::kLying,
          "remote"_a = true, "Create options; the arguments are the attributes.")
      .def_rw("power_level", &SupervisorOptions::power_level,
              "Level of Safety.power_protect(), 1 .. 10, which trips at 100 W times the level.\n\n"
              "Rises and descents are planned for half of this power. While the robot stands,\n"
              "stand.power_limit is reduced to 0.9 of this power if it is larger. 0 switches\n"
              "off the protection and this reduction; rises and descents are then planned for\n"
              "level 1.")
      .def_rw("arming_time", &SupervisorOptions::arming_time,
              "Time for which all arming checks must have passed [s].")
      .def_rw("temperature_warning", &SupervisorOptions::temperature_warning,
              "Motor temperature from which torque limits are reduced [deg C].")
      .def_rw("temperature_stop", &SupervisorOptions::temperature_stop,
              "Motor temperature from which torque limits are halved and the robot sits down\n"
              "[deg C].")
      .def_rw("battery_low", &SupervisorOptions::battery_low,
              "Battery charge below which the robot sits down [%].")
      .def_rw("payload_limit", &SupervisorOptions::payload_limit,
              "Payload above which the robot sits down [kg]; inf means no limit.")
      .def_rw("operator_timeout", &SupervisorOptions::operator_timeout,
              "Time without heartbeat() after which the robot sits down [s].\n\n"
              "inf: no operator is needed.")
      .def_rw("joint_margin", &SupervisorOptions::joint_margin,
              "Distance that joints must keep from their limits [rad], for arming and for the\n"
              "fault joint_stop.\n\n"
              "Negative: distance by which joints may exceed their limits. A fully folded calf\n"
              "rests on its stop, beyond the limits.")
      .def_rw("stand", &SupervisorOptions::stand, "Options of the controller's tick.")
      .def_rw("velocity_timeout", &SupervisorOptions::velocity_timeout,
              "See WalkOptions.velocity_timeout [s].")
      .def_rw("start", &SupervisorOptions::start, "State of the robot at the first sample.")
      .def_rw("remote", &SupervisorOptions::remote,
              "True if button B on the remote stops the robot.");
  nb::class_<Supervisor>(
      m, "Supervisor",
      "Controller that takes a robot from lying to standing and back, and lets it walk:\n"
      "LowState in, LowCmd out.\n\n"
      "The supervisor checks the robot before arming, refuses requests that the present\n"
      "mode does not allow, detects faults, and stops on request.\n\n"
      "Rising. First the legs fold from any pose, feet beside the body and knees up.\n"
      "Then the legs move through a crouch to the standing pose. All legs follow the\n"
      "same joint path. So the feet stay in place, and the body moves above the feet\n"
      "and then up. A leg that is blocked backs out and tries again, up to eight times.\n"
      "If the body rolls over its legs, the legs follow their joints without stiffness\n"
      "for 1 s and then fold again; this happens at most twice. A robot that already\n"
      "crouches or stands, with all joints within 0.35 rad of this path, rises from\n"
      "there without folding. Before the body leaves the ground, the folded legs are\n"
      "weighed and the rear legs press on the ground. These two checks detect the\n"
      "faults WIRING and WRONG_ROBOT. The speed is limited: the holding torques may\n"
      "take at most half of the power of power_level. Sitting down follows the same\n"
      "path backwards.\n\n"
      "Walking. In the mode WALK the robot follows set_velocity(), and stands at velocity\n"
      "0. It returns to STAND on request(STAND), when the velocity has expired, or for a\n"
      "fault that stops walking. Before it stands or sits down, it stops on four feet. If\n"
      "it has not stopped within 1.5 s, it sits down all the same. stop() and faults that\n"
      "damp act at once, in any phase of the gait.\n\n"
      "Torques fade between modes within 0.25 s; damping after a stop or a fault starts\n"
      "at once. fault_table() lists the faults and the reactions to them.\n\n"
      "Threads: update(), update_without_state(), report_link_lost(), report_conflict(),\n"
      "count_samples(), set_gains(), set_body_reference(), set_velocity(), gait, controller,\n"
      "command_is_fresh and measured_power belong to one thread. All other functions may be called "
      "from any\n"
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
          "    gains: Gains to use; None: robot.config.gains.\n"
          "    options: Options, fixed at construction.\n\n"
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
          "Returns the last command while it is at most 10 ms old, and damping after that.\n"
          "After 20 ms requests are refused until update() is called again. This function\n"
          "latches damping only after stop(). To latch damping after a long gap (surefoot\n"
          "run: 20 ms), call report_link_lost(). Real-time: yes.\n\n"
          "Args:\n"
          "    age: Age of the newest LowState [s], measured by the caller. Negative and\n"
          "        NaN count as too old.\n\n"
          "Returns:\n"
          "    The command to send, a copy.")
      .def("report_link_lost", &Supervisor::report_link_lost,
           "Report that no LowState arrived for too long, or that the robot restarted.\n\n"
           "If the robot is armed, damping is latched with the fault LINK. Pending requests\n"
           "are dropped. Real-time: yes.")
      .def("report_conflict", &Supervisor::report_conflict, "present"_a,
           "Report whether another program commands the robot, or a second robot sends\n"
           "LowStates, see RobotLink.conflict.\n\n"
           "While this is so, the arming check \"conflict\" fails. From the next update() on,\n"
           "arming and rising are refused, and a standing robot is not taken over. To damp a\n"
           "robot that is armed, call report_link_lost(), as Runner does. Real-time: yes.")
      .def("count_samples", &Supervisor::count_samples, "received"_a, "missing"_a,
           "Report how many LowStates the link received and missed since the last call.\n\n"
           "The arming check \"link\" uses these counts. They replace the counts of\n"
           "update(), because the link receives more samples than update() processes. The\n"
           "caller must then judge gaps itself and call report_link_lost(). Real-time: yes.\n\n"
           "Args:\n"
           "    received: Number of LowStates that arrived.\n"
           "    missing: Number of LowStates that did not arrive; negative if LowStates\n"
           "        counted as missing arrived later.")
      .def("request", &Supervisor::request, "mode"_a,
           "Request a mode. Returns the RequestStatus.\n\n"
           "Allowed requests: RISE from PASSIVE; SIT from RISE, STAND or WALK; STAND from SIT,\n"
           "to stand up again, and from WALK, to stop; WALK from STAND. A robot that walks\n"
           "stops before it changes its mode. Any thread. Real-time: yes.")
      .def("arm", &Supervisor::arm,
           "Arm the robot. Returns the RequestStatus.\n\n"
           "An armed robot accepts requests. Latched damping changes to PASSIVE, and a lost\n"
           "leg is used again. Any thread. Real-time: yes.")
      .def("stop", &Supervisor::stop,
           "Damp at once and latch damping, in any mode.\n\n"
           "Any thread, also repeatedly. Real-time: yes.")
      .def("heartbeat", &Supervisor::heartbeat,
           "Signal that the operator is present, see SupervisorOptions.operator_timeout.\n\n"
           "Any thread. Real-time: yes.")
      .def_prop_ro("mode", &Supervisor::mode, "Present mode. Any thread.")
      .def_prop_ro("armed", &Supervisor::armed, "True if the robot is armed. Any thread.")
      .def_prop_ro("damping_fault", &Supervisor::damping_fault,
                   "FaultId for which damping was last latched; NONE after arm(). Any thread.")
      .def_prop_ro("faults", &Supervisor::faults,
                   "Consistent copy of the active and past faults of the last tick.")
      .def_prop_ro("arming", &Supervisor::arming,
                   "Consistent copy of the arming checks of the last tick.")
      .def_prop_ro("rise_progress", &Supervisor::rise_progress,
                   "Reference position on the path from lying (0) to standing (1).\n\n"
                   "The value is 0 before the body rises, and in PASSIVE and DAMPING.")
      .def_prop_ro("rise_time", &Supervisor::rise_time,
                   "Planned time from folded legs to standing [s].")
      .def_prop_ro("fading", &Supervisor::fading,
                   "True while torques fade from one mode to the next.")
      .def_prop_ro(
          "rise_failed", &Supervisor::rise_failed,
          "True if the last rise was given up, because a leg could not fold or the body did\n"
          "not follow.")
      .def_prop_ro("rise_stage", &Supervisor::rise_stage,
                   "Stage of the present rise, or of the last one.")
      .def_prop_ro("command_is_fresh", &Supervisor::command_is_fresh,
                   "True if the last command was computed from the newest LowState.")
      .def_prop_ro("measured_power", &Supervisor::measured_power,
                   "Motor power in the last sample that the power protection judged [W].\n\n"
                   "The value is 0 while the protection is off or no torques are applied.")
      .def("set_gains", &Supervisor::set_gains, "gains"_a,
           "Set the gains, see StandController.set_gains().\n\n"
           "The gain fold_wait takes effect at the next folding. Raises Error and changes\n"
           "nothing if a gain is invalid. Real-time: no.")
      .def("set_body_reference", &Supervisor::set_body_reference, "target"_a,
           "Set the target pose of the body while standing, see\n"
           "StandController.set_body_reference().")
      .def("set_velocity", &Supervisor::set_velocity, "velocity"_a,
           "Set the WalkVelocity, see WalkController.set_velocity().\n\n"
           "Ignored unless the mode is WALK, and while the robot stops. Call it more often\n"
           "than SupervisorOptions.velocity_timeout. Real-time: yes.")
      .def_prop_rw("gait", &Supervisor::gait, &Supervisor::set_gait,
                   "Gait of the mode WALK; initially Gait.AUTO.")
      .def_prop_ro("stopping", &Supervisor::stopping,
                   "True while a robot that walked or stepped stops, before it stands or sits\n"
                   "down.")
      .def_prop_ro("controller", &Supervisor::controller, nb::rv_policy::reference_internal,
                   "The WalkController of a robot that stands or walks, not a copy; only for\n"
                   "reading.");
}

}  // namespace

void bind_supervisor(nb::module_& m) {
  bind_enums(m);
  bind_faults(m);
  bind_arming(m);
  bind_supervisor_class(m);
}
