// SPDX-License-Identifier: BSD-3-Clause
#include <nanobind/eigen/dense.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/string.h>

#include "bindings.hpp"
#include "pending_error.hpp"
#include "surefoot/stand_controller.hpp"

namespace nb = nanobind;
using namespace nb::literals;
using namespace surefoot;

namespace {

void bind_body_reference(nb::module_& m) {
  nb::class_<BodyReference>(m, "BodyReference",
                            "Where the body is asked to be, from the pose that was latched.\n\n"
                            "Along the axes of the support frame: forward, left, out of the "
                            "ground.")
      .def(
          "__init__",
          [](BodyReference* r, double x, double y, double height, double roll, double pitch,
             double yaw) { new (r) BodyReference{x, y, height, roll, pitch, yaw}; },
          "x"_a = 0.0, "y"_a = 0.0, "height"_a = 0.0, "roll"_a = 0.0, "pitch"_a = 0.0,
          "yaw"_a = 0.0)
      .def_rw("x", &BodyReference::x, "Forward [m].")
      .def_rw("y", &BodyReference::y, "To the left [m].")
      .def_rw("height", &BodyReference::height, "Out of the ground [m].")
      .def_rw("roll", &BodyReference::roll, "About forward [rad].")
      .def_rw("pitch", &BodyReference::pitch, "About left [rad].")
      .def_rw("yaw", &BodyReference::yaw, "About up [rad].");
  nb::enum_<ReachLimit>(m, "ReachLimit", "What keeps the body from going where it is asked to.")
      .value("NONE", ReachLimit::kNone, "Nothing: it is there, or on its way.")
      .value("JOINT", ReachLimit::kJoint, "A joint would come too near its limit.")
      .value("SUPPORT", ReachLimit::kSupport, "The centre of mass would come too near the edge.")
      .value("FOOT_HEIGHT", ReachLimit::kFootHeight,
             "A foot would come within gain reach_foot_depth of the height of its hip axis.")
      .value("UNREACHABLE", ReachLimit::kUnreachable, "A leg is too short.")
      .value("NOT_FINITE", ReachLimit::kNotFinite, "No number; the last request stands.");
  nb::class_<ReachStatus>(m, "ReachStatus", "A limit, and whose it is.")
      .def_ro("limit", &ReachStatus::limit, "Which.")
      .def_ro("motor", &ReachStatus::motor,
              "SDK motor: JOINT the joint's, FOOT_HEIGHT the leg's hip; else -1.");
}

void bind_rung(nb::module_& m) {
  nb::enum_<FallbackLevel>(m, "FallbackLevel",
                           "Where a command comes from: a ladder, the best first.")
      .value("SOLVED", FallbackLevel::kSolved, "The whole-body program.")
      .value("COLD_SOLVE", FallbackLevel::kColdSolve,
             "The same program once more, from nothing and to ten times the tolerance.")
      .value("FORCES", FallbackLevel::kForces,
             "No program: the last solution's forces, and what the body's tasks want more than\n"
             "then, shared among the feet.")
      .value("LAST_FORCES", FallbackLevel::kLastForces,
             "The last solution's forces, through today's Jacobians.")
      .value("GRAVITY", FallbackLevel::kGravity,
             "The weight shared among the feet, and damping of the joints.")
      .value("HOLD", FallbackLevel::kHold,
             "The command that left last, once more: the report is bad.")
      .value("DAMPING", FallbackLevel::kDamping, "The motors brake by themselves.");
}

void bind_controller(nb::module_& m) {
  nb::class_<StandOptions>(m, "StandOptions", "What is set once, as opposed to tuned.")
      .def(
          "__init__",
          [](StandOptions* o, double motor_damping, double delay, QpForm form, double power_limit) {
            new (o) StandOptions{motor_damping, delay, form, power_limit};
          },
          "motor_damping"_a = 0.0, "delay"_a = 0.0, "form"_a = QpForm::kAuto,
          "power_limit"_a = StandOptions().power_limit)
      .def_rw("motor_damping", &StandOptions::motor_damping,
              "[N.m.s/rad] motor-side damping in every command; 0 is pure torque mode.")
      .def_rw("delay", &StandOptions::delay, "[s] from a measurement to its command's action.")
      .def_rw("form", &StandOptions::form, "Of the whole-body program.")
      .def_rw("power_limit", &StandOptions::power_limit,
              "[W] most that a command may take, sum |tau dq| by the velocities reported; beyond\n"
              "it torques are scaled towards those that hold still, unless these alone take more;\n"
              "a leg that gathers speed along its own torques gets no more of them than its power\n"
              "rises by a quarter of the limit within 15 ms. > 0, infinite is off.");
  nb::class_<StandController>(
      m, "StandController",
      "Holds the body as it stands, or where it is asked to be: LowState in, LowCmd out.\n\n"
      "Torque mode: Kp = Kd = 0, q = PosStopF, dq = VelStopF. A bad report or solve is bridged,\n"
      "as Rung has it, for at most 10 ms; then the motors damp until reset().")
      .def(
          "__init__",
          [](StandController* self, const Robot& robot, const Gains* gains,
             const StandOptions& options) {
            new (self) StandController(robot, gains ? *gains : robot.config().gains, options);
          },
          "robot"_a, "gains"_a = nb::none(), "options"_a = StandOptions(),
          "gains: None for the robot's own. Raise Error if one or an option is invalid.")
      .def(
          "update",
          [](StandController& c, const LowState& s) {
            LowCmd command(c.update(s));
            raise_pending_error();
            return command;
          },
          "low_state"_a,
          "Compute one tick: LowCmd; read status. Raises only what a task in Python raised.")
      .def("set_body_reference", &StandController::set_body_reference, "target"_a,
           "Ask for another pose of the body; it goes there at limited speed.")
      .def_prop_ro("body_reference", &StandController::body_reference, "Where it is on the way.")
      .def_prop_ro("reach", &StandController::reach, "What keeps it from getting there.")
      .def("give_up_leg", &StandController::give_up_leg, "leg"_a,
           "Give a leg up (0 .. 3) until reset: its foot bears nothing from now on.")
      .def_prop_ro("lost_leg", &StandController::lost_leg, "The leg that was given up, or -1.")
      .def("capture_margin_without", &StandController::capture_margin_without, "leg"_a,
           "Return how far the capture point is inside the other three feet's triangle [m].\n\n"
           "Infinite where another leg is lost, NaN for no leg's number and before the first tick.")
      .def("add_task", &StandController::add_task, "task"_a, "Add a task of your own.")
      .def_prop_ro("status", &StandController::status, "What this tick's command is worth.")
      .def_prop_ro("fault", &StandController::fault, "What was wrong when a tick last was not OK.")
      .def_prop_ro("fallback_level", &StandController::fallback_level,
                   "Where this tick's command came from.")
      .def("fallback_count", &StandController::fallback_count, "fallback_level"_a,
           "Return how many ticks came to this rung, since construction.")
      .def_prop_ro(
          "state", [](const StandController& c) { return RobotState(c.state()); },
          "Estimate, a copy; its friction is what the program may use of it.")
      .def_prop_ro(
          "reference", [](const StandController& c) { return Reference(c.reference()); }, "A copy.")
      .def_prop_ro(
          "qp", [](const StandController& c) { return QpProblem(c.qp()); },
          "The program that the last tick solved: a copy.")
      .def_prop_ro(
          "solution", [](const StandController& c) { return Solution(c.solution()); }, "A copy.")
      .def_prop_ro(
          "estimator_report",
          [](const StandController& c) { return EstimatorReport(c.estimator_report()); }, "A copy.")
      .def_prop_ro("normal_forces_from_torques", &StandController::normal_forces_from_torques,
                   "Normal force per foot from torques [N].")
      .def_prop_ro("has_foot_force_est", &StandController::has_foot_force_est,
                   "Does footForceEst live?")
      .def_prop_ro("command_power", &StandController::command_power,
                   "Sum |tau dq| [W] of the last command made from a report.")
      .def_prop_ro("power_scale", &StandController::power_scale,
                   "How much of the torques' way from holding still power_limit left, 0 .. 1.\n"
                   "It is 1, too, where a leg that its torques fling got less of them.")
      .def_prop_ro(
          "gains", [](const StandController& c) { return Gains(c.gains()); },
          "A copy of those asked for.")
      .def_prop_ro(
          "active_gains", [](const StandController& c) { return Gains(c.active_gains()); },
          "A copy; on their way to `gains`.")
      .def("set_gains", &StandController::set_gains, "gains"_a,
           "Change gains; those of a controller at work move there in 0.1 s of good ticks, for "
           "torques not to jump; while nothing is computed, at once. Raise Error, and change "
           "nothing, if one is invalid.")
      .def("reset", &StandController::reset, "Leave damping; latch the pose anew.");
}

}  // namespace

void bind_stand(nb::module_& m) {
  bind_body_reference(m);
  bind_rung(m);
  bind_controller(m);
}
