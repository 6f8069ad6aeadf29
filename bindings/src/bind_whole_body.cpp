// SPDX-License-Identifier: BSD-3-Clause
#include <nanobind/eigen/dense.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/string.h>

#include "bindings.hpp"
#include "pending_error.hpp"
#include "surefoot/whole_body_controller.hpp"

namespace nb = nanobind;
using namespace nb::literals;
using namespace surefoot;

namespace {

void bind_options(nb::module_& m) {
  nb::class_<WholeBodyOptions>(m, "WholeBodyOptions", "What is set once, as opposed to tuned.")
      .def(
          "__init__",
          [](WholeBodyOptions* o, QpForm form, double tolerance) {
            new (o) WholeBodyOptions{form, tolerance};
          },
          "form"_a = QpForm::kAuto, "tolerance"_a = 1e-6)
      .def_rw("form", &WholeBodyOptions::form, "AUTO, CONDENSED or GENERAL.")
      .def_rw("tolerance", &WholeBodyOptions::tolerance, "Of the program's scaled residuals.");
}

void bind_qp_problem(nb::module_& m) {
  nb::class_<QpProblem>(m, "QpProblem",
                        "A quadratic program: minimise 1/2 x'H x + g'x  subject to  A x = b,  "
                        "l <= C x <= u.\n\n"
                        "Bounds of 1e20 and beyond are none. Arrays are copies.")
      .def_ro("H", &QpProblem::H, nb::rv_policy::copy, "Shape (n, n), symmetric.")
      .def_ro("g", &QpProblem::g, nb::rv_policy::copy, "Shape (n,).")
      .def_ro("A", &QpProblem::A, nb::rv_policy::copy, "Shape (equalities, n).")
      .def_ro("b", &QpProblem::b, nb::rv_policy::copy, "Shape (equalities,).")
      .def_ro("C", &QpProblem::C, nb::rv_policy::copy, "Shape (inequalities, n).")
      .def_ro("l", &QpProblem::l, nb::rv_policy::copy, "Shape (inequalities,).")
      .def_ro("u", &QpProblem::u, nb::rv_policy::copy, "Shape (inequalities,).");
}

}  // namespace

void bind_whole_body(nb::module_& m) {
  bind_options(m);
  bind_qp_problem(m);
  nb::class_<WholeBodyController>(m, "WholeBodyController",
                                  "State and reference in, joint torques out.\n\n"
                                  "For people who bring their own estimator or planner.")
      .def(
          "__init__",
          [](WholeBodyController* self, const Robot& robot, const Gains* gains,
             const WholeBodyOptions& options) {
            new (self) WholeBodyController(robot, gains ? *gains : robot.config().gains, options);
          },
          "robot"_a, "gains"_a = nb::none(), "options"_a = WholeBodyOptions(),
          "gains: None for the robot's own. Raise Error if one or an option is invalid.")
      .def(
          "update",
          [](WholeBodyController& c, const RobotState& s, const Reference& r) {
            Solution solution(c.update(s, r));
            raise_pending_error();
            return solution;
          },
          "state"_a, "reference"_a,
          "Compute one tick: Solution. Raises only what a task written in Python raised.")
      .def("hold", &WholeBodyController::hold, "state"_a,
           "Make the reference that asks the robot to stay as it is; raises Error on a wrong size.")
      .def("add_task", &WholeBodyController::add_task, "task"_a,
           "Add a task of your own, from the next tick on; raises Error.")
      .def("set_gains", &WholeBodyController::set_gains, "gains"_a,
           "Raise Error if one is invalid.")
      .def_prop_ro(
          "gains", [](const WholeBodyController& c) { return Gains(c.gains()); }, "A copy.")
      .def_prop_ro(
          "qp", [](const WholeBodyController& c) { return QpProblem(c.qp()); },
          "The program that the last tick solved, with slacks where something gave: a copy.")
      .def("reset", &WholeBodyController::reset, "Forget the warm start.");
}
