// SPDX-License-Identifier: BSD-3-Clause
#include <nanobind/eigen/dense.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/trampoline.h>

#include "bindings.hpp"
#include "pending_error.hpp"
#include "surefoot/error.hpp"
#include "surefoot/task.hpp"

namespace nb = nanobind;
using namespace nb::literals;
using namespace surefoot;

namespace {

struct PythonTask : Task {
  NB_TRAMPOLINE(Task);
  int rows() const override {
    constexpr std::uint64_t hash = nb::detail::str_hash("rows");
    const nb::detail::ticket ticket(nb_trampoline, "rows", hash, true);
    const nb::object answer = nb_trampoline.base().attr(ticket.key)();
    int rows = 0;
    if (nb::try_cast<int>(answer, rows)) return rows;
    const nb::str name = nb::cast<nb::str>(nb_trampoline.base().type().attr("__name__"));
    throw Error("task " + std::string(name.c_str()) + ": rows() returned " +
                nb::repr(answer).c_str() + ", expected an integer 1 .. 1000");
  }
  bool write(const RobotState& state, TaskRows& out) noexcept override {
    try {
      constexpr std::uint64_t hash = nb::detail::str_hash("write");
      const nb::detail::ticket ticket(nb_trampoline, "write", hash, true);
      // Pass pointers, so that Python writes into these rows and not into a copy.
      return lets_continue(nb_trampoline.base().attr(ticket.key)(&state, &out));
    } catch (...) {
      store_pending_error();
    }
    return false;
  }
};

}  // namespace

void bind_task(nb::module_& m) {
  nb::class_<TaskRows>(
      m, "TaskRows",
      "Rows of a custom task. The arrays are views; write into them, ``A_a[:] = ...``.\n\n"
      "The QP adds this cost to its own tasks; a are the generalised accelerations, f\n"
      "the contact forces::\n\n"
      "    1/2 sum_i weight_i (A_a a + A_f f - b)_i^2\n\n"
      "For scale: with gain weight_com_vertical = 1, an error of g/2 in the\n"
      "acceleration of the centre of mass costs 1/2. Rows whose cost is more than 1e5\n"
      "times that of the QP's own tasks end the tick with BAD_TASK.")
      .def_prop_ro(
          "A_a", [](TaskRows& r) -> Eigen::Ref<Eigen::MatrixXd> { return r.A_a; },
          nb::rv_policy::reference_internal,
          "Matrix A_a for the generalised accelerations, shape (rows, nv), Pinocchio's\n"
          "order.")
      .def_prop_ro(
          "A_f", [](TaskRows& r) -> Eigen::Ref<Eigen::MatrixXd> { return r.A_f; },
          nb::rv_policy::reference_internal,
          "Matrix A_f for the contact forces [N], shape (rows, 12), world axes, FR FL RR\n"
          "RL.")
      .def_prop_ro(
          "b", [](TaskRows& r) -> Eigen::Ref<Eigen::VectorXd> { return r.b; },
          nb::rv_policy::reference_internal, "Desired values b, shape (rows,).")
      .def_prop_ro(
          "weight", [](TaskRows& r) -> Eigen::Ref<Eigen::VectorXd> { return r.weight; },
          nb::rv_policy::reference_internal,
          "Weight of each row, shape (rows,), >= 0; initially 1.");
  nb::class_<Task, PythonTask>(
      m, "Task",
      "Base class of custom tasks. Derive a class and pass an instance to add_task().\n\n"
      "An exception in write() ends the tick with BAD_TASK; update() raises it after\n"
      "the tick. See examples/custom_task.py.")
      .def(nb::init<>(), "Create a task; call this method from the __init__() of a derived class.")
      .def("rows", &Task::rows, "Return the number of rows, 1 .. 1000. Called once, by add_task().")
      .def("write", &Task::write, "state"_a, "rows"_a,
           "Write the rows for a state. Rows that are not written keep the values of the\n"
           "last tick.\n\n"
           "The acceleration of a frame is J a + Jdot v with v from state, in Pinocchio's\n"
           "conventions. Called in every tick.\n\n"
           "Args:\n"
           "    state: RobotState of this tick; valid during the call only.\n"
           "    rows: TaskRows to write; valid during the call only.\n\n"
           "Returns:\n"
           "    False to end the tick with BAD_TASK; True or None to continue. A number that\n"
           "    is not finite, or a negative weight, also ends the tick with BAD_TASK.");
}
