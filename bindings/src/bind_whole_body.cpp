// SPDX-License-Identifier: BSD-3-Clause
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/string.h>

#include "bindings.hpp"
#include "pending_error.hpp"
#include "surefoot/whole_body_controller.hpp"
#include "value_class.hpp"

using namespace nb::literals;
using namespace surefoot;

namespace {

void bind_options(nb::module_& m) {
  ValueClass<WholeBodyOptions>(
      m, "WholeBodyOptions",
      "Options of a WholeBodyController: fixed at construction, unlike gains.")
      .def(
          "__init__",
          [](WholeBodyOptions* o, FieldArgument<QpForm> form, FieldArgument<double> tolerance) {
            constexpr const char* kType = "WholeBodyOptions";
            new (o) WholeBodyOptions{form.to(kType, "form"), tolerance.to(kType, "tolerance")};
          },
          "form"_a = QpForm::kAuto, "tolerance"_a = 1e-6,
          "Create options; the arguments are the attributes.")
      .def_rw("form", &WholeBodyOptions::form, "Form of the QP, AUTO, CONDENSED or GENERAL.")
      .def_rw("tolerance", &WholeBodyOptions::tolerance,
              "Tolerance of the residuals of the scaled QP, 1e-14 .. 1e-3.");
}

void bind_qp_problem(nb::module_& m) {
  nb::class_<QpProblem>(
      m, "QpProblem",
      "Quadratic program: minimise 1/2 x'H x + g'x subject to A x = b and l <= C x <=\n"
      "u.\n\n"
      "Arrays are copies.")
      .def_ro("H", &QpProblem::H, nb::rv_policy::copy,
              "Matrix of the quadratic cost, shape (n, n), symmetric.")
      .def_ro("g", &QpProblem::g, nb::rv_policy::copy, "Vector of the linear cost, shape (n,).")
      .def_ro("A", &QpProblem::A, nb::rv_policy::copy, "Matrix of the equalities, shape (n_eq, n).")
      .def_ro("b", &QpProblem::b, nb::rv_policy::copy,
              "Right-hand side of the equalities, shape (n_eq,).")
      .def_ro("C", &QpProblem::C, nb::rv_policy::copy,
              "Matrix of the inequalities, shape (n_in, n).")
      .def_ro("l", &QpProblem::l, nb::rv_policy::copy,
              "Lower bounds of C x, shape (n_in,); <= -1e20 means no bound.")
      .def_ro("u", &QpProblem::u, nb::rv_policy::copy,
              "Upper bounds of C x, shape (n_in,); >= 1e20 means no bound.");
}

}  // namespace

void bind_whole_body(nb::module_& m) {
  bind_options(m);
  bind_qp_problem(m);
  nb::class_<WholeBodyController>(
      m, "WholeBodyController",
      "Whole-body controller for users with their own estimator or planner: RobotState\n"
      "and Reference in, joint torques out.\n\n"
      "Each tick solves one QP. Cost: errors in the desired accelerations of the body\n"
      "(centre of mass or base, orientation, angular momentum), of the posture and of\n"
      "custom tasks, and the distance of the contact forces from the even forces.\n"
      "Equality constraints: rigid-body dynamics with armature, and the desired\n"
      "accelerations of the contact points. One exception: in the general form, the\n"
      "desired acceleration of the foot of a nearly singular leg is a cost, not a\n"
      "constraint. Near the support edge, the joint limits of an unloaded leg are\n"
      "lifted in the QP and applied afterwards. Hard constraints: friction and largest\n"
      "normal force of each foot, which always allow f = 0. Elastic constraints with\n"
      "exact penalties: motor torque (torque-speed curve), joint position and velocity,\n"
      "and hold-down. They keep the QP feasible. Finally the torques are clipped to the\n"
      "motor limits; Solution.clipped_torque is the largest amount clipped.\n"
      "docs/explanation/condensed-qp.md has the equations.\n\n"
      "Assumes spherical feet that roll, and one ground normal for all feet. Not\n"
      "thread-safe.")
      .def(
          "__init__",
          [](WholeBodyController* self, const Robot& robot, const Gains* gains,
             const WholeBodyOptions& options) {
            new (self) WholeBodyController(robot, gains ? *gains : robot.config().gains, options);
          },
          "robot"_a, "gains"_a = nb::none(), "options"_a = WholeBodyOptions(),
          "Create a controller.\n\n"
          "Args:\n"
          "    robot: Model and configuration.\n"
          "    gains: Gains to use; None: robot.config.gains.\n"
          "    options: Options, fixed at construction.\n\n"
          "Raises:\n"
          "    Error: The robot does not fit the form of the QP, a leg is singular in its\n"
          "        standing pose, or a gain or an option is invalid.")
      .def(
          "update",
          [](WholeBodyController& c, const RobotState& s, const Reference& r) {
            Solution solution(c.update(s, r));
            raise_pending_error();
            return solution;
          },
          "state"_a, "reference"_a,
          "Compute one tick.\n\n"
          "The controller raises no exception. If a Python task raised an exception, this\n"
          "exception is raised after the tick. Real-time: yes, if the custom tasks are.\n\n"
          "Args:\n"
          "    state: q (nq,) and v (nv,) in Pinocchio's order; contact confidence 0 .. 1\n"
          "        per foot.\n"
          "    reference: Desired motion, in the world frame of state.\n\n"
          "Returns:\n"
          "    The solution, a copy. If the status is neither OK nor SATURATED, all fields\n"
          "    other than status, iterations and residuals keep the values of the last good\n"
          "    tick.")
      .def("hold", &WholeBodyController::hold, "state"_a,
           "Return a reference that keeps the robot in its present pose.\n\n"
           "The reference has the centre of mass, base pose, contact points and posture of\n"
           "`state`, and zero velocities. Raises Error if q or v has the wrong size, a value\n"
           "is not finite or out of range, or the quaternion is not of unit length.\n"
           "Real-time: no.")
      .def("add_task", &WholeBodyController::add_task, "task"_a,
           "Add a custom task, in force from the next tick on.\n\n"
           "Raises Error if task is None or its rows() is not 1 .. 1000. Real-time: no.")
      .def("set_gains", &WholeBodyController::set_gains, "gains"_a,
           "Set the gains, between ticks. Raises Error and changes nothing if a gain is\n"
           "invalid. Real-time: no.")
      .def_prop_ro(
          "gains", [](const WholeBodyController& c) { return Gains(c.gains()); },
          "Gains last set, a copy.")
      .def_prop_ro(
          "qp", [](const WholeBodyController& c) { return QpProblem(c.qp()); },
          "Scaled QP that the last tick solved, for benchmarks and debugging; a copy.\n\n"
          "If no elastic constraint is violated, this is the QP without slack variables;\n"
          "else it is the QP with slack variables.")
      .def("reset", &WholeBodyController::reset,
           "Discard the warm start and the last contact forces; Solution.status becomes\n"
           "WAITING.\n\n"
           "Real-time: yes.");
}
