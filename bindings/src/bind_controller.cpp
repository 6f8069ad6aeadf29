// SPDX-License-Identifier: BSD-3-Clause
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/string.h>

#include "bindings.hpp"
#include "pending_error.hpp"
#include "planner_argument.hpp"
#include "surefoot/controller.hpp"
#include "value_class.hpp"

using namespace nb::literals;
using namespace surefoot;

namespace {

void bind_fallback_level(nb::module_& m) {
  nb::enum_<FallbackLevel>(
      m, "FallbackLevel",
      "Where a command comes from, the best source first.\n\n"
      "This order is the fallback chain. A tick tries the levels in this order until\n"
      "one level gives a command.")
      .value("SOLVED", FallbackLevel::kSolved,
             "The whole-body QP, started from the active set of the last tick.")
      .value("COLD_SOLVE", FallbackLevel::kColdSolve,
             "The same QP again, from a cold start and with ten times the tolerance.")
      .value("FORCES", FallbackLevel::kForces,
             "No QP, but the forces of the last solution. The change of the desired wrench\n"
             "since then is shared among the feet and added.")
      .value("LAST_FORCES", FallbackLevel::kLastForces,
             "Torques from the forces of the last solution and the present Jacobians.")
      .value("GRAVITY", FallbackLevel::kGravity,
             "Torques that hold the weight of the robot, and damping by the motors.")
      .value("HOLD", FallbackLevel::kHold,
             "The last command again, because no other level gave a command.")
      .value("DAMPING", FallbackLevel::kDamping, "The motors brake by themselves.");
}

void bind_options(nb::module_& m) {
  ValueClass<ControllerOptions>(m, "ControllerOptions",
                                "Options of a Controller: fixed at construction, unlike gains.")
      .def(
          "__init__",
          [](ControllerOptions* o, FieldArgument<double> motor_damping, FieldArgument<double> delay,
             FieldArgument<QpForm> form, FieldArgument<double> power_limit) {
            constexpr const char* kType = "ControllerOptions";
            new (o) ControllerOptions{motor_damping.to(kType, "motor_damping"),
                                      delay.to(kType, "delay"), form.to(kType, "form"),
                                      power_limit.to(kType, "power_limit")};
          },
          "motor_damping"_a = 0.0, "delay"_a = 0.0, "form"_a = QpForm::kAuto,
          "power_limit"_a = ControllerOptions().power_limit,
          "Create options; the arguments are the attributes.")
      .def_rw("motor_damping", &ControllerOptions::motor_damping,
              "Kd of every command [N.m.s/rad], joint-side, with dq = 0; 0 .. 50.\n\n"
              "0 is pure torque mode. Robots whose knees vibrate in pure torque mode may need a\n"
              "value above 0.")
      .def_rw("delay", &ControllerOptions::delay,
              "Time from a measurement to the moment when the command computed from it acts\n"
              "[s], 0 .. 0.05.\n\n"
              "identify_delay() measures this time. The controller predicts the state over this\n"
              "time from the commands already sent. Prediction amplifies sensor noise, so leave\n"
              "the option at 0 if the real delay is at most a few ticks. In simulation no robot\n"
              "stood with a delay above 0.03 s.\n\n"
              "At 0 nothing is predicted, and the estimator compares the sample of tick k with\n"
              "the command of tick k - 3, which acted while the sample was measured: over the\n"
              "SDK's link, commands and samples each take one period.")
      .def_rw("form", &ControllerOptions::form,
              "Form of the whole-body QP, AUTO, CONDENSED or GENERAL.")
      .def_rw("power_limit", &ControllerOptions::power_limit,
              "Largest power of a command [W], > 0; inf switches the limit off.\n\n"
              "The power is sum ``|tau dq|`` with the motors' damping included, at the joint\n"
              "velocities for which the command is computed. Above the limit, the torques are\n"
              "scaled towards the holding torques, which hold the robot against gravity. If the\n"
              "holding torques alone exceed the limit, the command is not scaled, because a\n"
              "robot with too little torque falls, and its motors then take even more power.\n"
              "Finally, the torques of runaway legs are limited: the power of a leg may rise by\n"
              "at most a quarter of the limit within the next 15 ms, extrapolated from the\n"
              "acceleration of its joints. With periods of 10 ms and more, runaway legs are not\n"
              "detected.\n\n"
              "Set this limit below that of Safety.power_protect(), for example at 0.9 of it,\n"
              "but not far below the power that the motions take. A robot that lacks power for\n"
              "long falls.");
}

}  // namespace

void bind_controller(nb::module_& m) {
  bind_fallback_level(m);
  bind_options(m);
  nb::class_<Controller>(
      m, "Controller",
      "Controller that moves the robot as a Planner plans: LowState in, LowCmd out.\n\n"
      "A tick estimates the state, calls the planner for the Reference and solves the\n"
      "whole-body QP. Commands are in torque mode: motors 0 .. 11 have mode 0x0A,\n"
      "q = PosStopF, dq = VelStopF, Kp = Kd = 0 and the torques of the QP.\n\n"
      "If the solve fails or the reference is invalid, the tick tries the fallback\n"
      "levels in order, see FallbackLevel. If the sample is unusable or the robot has\n"
      "fallen, the last command is repeated. If the estimate diverges, or after a gap of\n"
      "more than 100 ms, the motors damp at once. Commands have Kd > 0 only with\n"
      "ControllerOptions.motor_damping, for a lost leg, and at the levels GRAVITY and\n"
      "DAMPING. At most 10 ms may pass without a solved command; then the motors damp\n"
      "(dq = 0, Kd > 0, tau = 0). This damping is latched until reset(). All times are\n"
      "measured with LowState.tick.\n\n"
      "Assumes twelve joints on a free base, spherical feet, and one ground plane under\n"
      "all stance feet. Not thread-safe.")
      .def(
          "__init__",
          [](Controller* self, const Robot& robot, nb::handle planner, const Gains* gains,
             const ControllerOptions& options) {
            new (self) Controller(robot, planner_argument(planner),
                                  gains ? *gains : robot.config().gains, options);
          },
          "robot"_a, "planner"_a.none(), "gains"_a = nb::none(), "options"_a = ControllerOptions(),
          nb::sig("def __init__(self, robot: Robot, planner: Planner, gains: Gains | None = None, "
                  "options: ControllerOptions = ...) -> None"),
          "Create a controller.\n\n"
          "Args:\n"
          "    robot: Model and configuration, twelve joints on a free base.\n"
          "    planner: Planner of this controller alone; reset() resets it too.\n"
          "    gains: Gains to use; None: robot.config.gains.\n"
          "    options: Options, fixed at construction.\n\n"
          "Raises:\n"
          "    TypeError: `planner` is no Planner, or its class lacks plan() or reset().\n"
          "    Error: The robot does not have twelve joints on a free base, or a gain or an\n"
          "        option is invalid.")
      .def(
          "update",
          [](Controller& c, const LowState& s) {
            LowCmd command(c.update(s));
            raise_pending_error();
            return command;
          },
          "low_state"_a,
          "Compute one tick.\n\n"
          "The controller raises no exception. If a Python task or planner raised an\n"
          "exception, this exception is raised after the tick. Real-time: yes, if the planner\n"
          "and the custom tasks are.\n\n"
          "Args:\n"
          "    low_state: Newest sample; its tick must advance.\n\n"
          "Returns:\n"
          "    The command to send, a copy. status and fallback_level report its quality.")
      .def("declare_leg_lost", &Controller::declare_leg_lost, "leg"_a,
           "Give up a leg, 0 .. 3, until reset().\n\n"
           "Its foot carries no load from now on, its motors damp, and the planner receives it\n"
           "as PlannerInput.lost_leg. The call is ignored if a leg is already lost or leg is\n"
           "not 0 .. 3. Real-time: yes.")
      .def_prop_ro("lost_leg", &Controller::lost_leg, "Leg that was given up, 0 .. 3, or -1.")
      .def("add_task", &Controller::add_task, "task"_a,
           "Add a custom task, in force from the next tick on.\n\n"
           "Raises Error if task is None or its rows() is not 1 .. 1000. Real-time: no.")
      .def_prop_ro(
          "status", &Controller::status,
          "Status of the last tick.\n\n"
          "OK, SATURATED, or the reason why the QP gave no command. DAMPING while damping\n"
          "is latched.")
      .def_prop_ro(
          "fault", &Controller::fault,
          "Status of the last tick without a usable command; kept while damping is latched,\n"
          "OK after reset().")
      .def_prop_ro("fallback_level", &Controller::fallback_level,
                   "Fallback level of the last command; DAMPING before the first tick.")
      .def("fallback_count", &Controller::fallback_count, "fallback_level"_a,
           "Return the number of ticks that ended at a fallback level, since construction.\n\n"
           "Real-time: yes.")
      .def_prop_ro(
          "state", [](const Controller& c) { return RobotState(c.state()); },
          "Estimated state, a copy.\n\n"
          "After a tick that reached the QP, friction in this state is the share of\n"
          "RobotConfig.friction that the QP could use: in general at most 0.7 while the\n"
          "capture point is more than 6 cm inside the support edges, and less while a foot\n"
          "slips; all of them of the learnt friction. After any other tick it contains only the\n"
          "learnt friction and the reduction for slipping feet.")
      .def_prop_ro(
          "reference", [](const Controller& c) { return Reference(c.reference()); },
          "Reference that the last tick with a good estimate used, a copy.\n\n"
          "It is that of the planner, or the last valid one if the status is BAD_REFERENCE.")
      .def_prop_ro(
          "qp", [](const Controller& c) { return QpProblem(c.qp()); },
          "QP that the last tick solved, a copy; see WholeBodyController.qp.")
      .def_prop_ro(
          "solution", [](const Controller& c) { return Solution(c.solution()); },
          "QP solution of the last good tick, a copy.")
      .def_prop_ro(
          "estimator_report",
          [](const Controller& c) { return EstimatorReport(c.estimator_report()); },
          "Uncertainty of the state and verdicts on the sensors, a copy.")
      .def_prop_ro("normal_forces_from_torques", &Controller::normal_forces_from_torques,
                   "Normal force on each foot [N], computed from the joint torques, FR FL RR RL,\n"
                   "shape (4,).")
      .def_prop_ro(
          "has_foot_force_est", &Controller::has_foot_force_est,
          "True if footForceEst works on this robot, because its sum has matched the load\n"
          "on the feet.")
      .def_prop_ro(
          "command_power", &Controller::command_power,
          "Power sum ``|tau dq|`` [W] of the last command that was computed from a sample.\n\n"
          "The motors' damping is included. dq are the joint velocities for which the\n"
          "command was computed: measured, or predicted over ControllerOptions.delay. A lost leg\n"
          "counts with its torques before they were set to zero. The power exceeds\n"
          "ControllerOptions.power_limit only if the torques that hold the robot exceed this\n"
          "limit.")
      .def_prop_ro(
          "power_scale", &Controller::power_scale,
          "Scale s, 0 .. 1, by which power_limit reduced the torques of the last good tick.\n\n"
          "tau = tau_hold + s (tau_QP - tau_hold) for the legs that carry. Below 1, status is\n"
          "SATURATED, and solution has the torques of the QP. If only swing legs or a runaway leg\n"
          "were limited, status is SATURATED and s is 1.")
      .def_prop_ro(
          "gains", [](const Controller& c) { return Gains(c.gains()); },
          "Gains last set, a copy; see set_gains().")
      .def_prop_ro(
          "active_gains", [](const Controller& c) { return Gains(c.active_gains()); },
          "Gains of the last tick, a copy. After set_gains() they approach `gains` within\n"
          "0.1 s.")
      .def("set_gains", &Controller::set_gains, "gains"_a,
           "Set the gains, between ticks.\n\n"
           "While the controller is active, active_gains approach the new gains within 0.1\n"
           "s, counted over good ticks only, so that torques do not jump. Before the first\n"
           "good sample and while damping is latched, they change at once. Raises Error and\n"
           "changes nothing if a gain is invalid. Real-time: no.")
      .def(
          "reset",
          [](Controller& c) {
            c.reset();
            raise_pending_error();
          },
          "Leave damping, clear the lost leg and the reference, reset the planner, and start\n"
          "again with the next good sample.\n\n"
          "An exception in the reset() of a Python planner is raised afterwards. Real-time:\n"
          "yes, if the planner is.");
}
