// SPDX-License-Identifier: BSD-3-Clause
#include <nanobind/eigen/dense.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/trampoline.h>

#include <exception>
#include <utility>

#include "bindings.hpp"
#include "pending_error.hpp"
#include "surefoot/error.hpp"
#include "surefoot/task.hpp"

namespace nb = nanobind;
using namespace nb::literals;
using namespace surefoot;

namespace {

thread_local std::exception_ptr pending_error;

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
                nb::repr(answer).c_str() + ", expected a whole number");
  }
  bool write(const RobotState& state, TaskRows& out) noexcept override {
    try {
      constexpr std::uint64_t hash = nb::detail::str_hash("write");
      const nb::detail::ticket ticket(nb_trampoline, "write", hash, true);
      // Pointers, so that Python writes into these rows and not into a copy.
      const nb::object result = nb_trampoline.base().attr(ticket.key)(&state, &out);
      if (result.is_none()) return true;
      const int truth = PyObject_IsTrue(result.ptr());
      if (truth < 0) throw nb::python_error();
      return truth == 1;
    } catch (...) {
      if (!pending_error) pending_error = std::current_exception();
    }
    return false;
  }
};

}  // namespace

void raise_pending_error() {
  if (pending_error) std::rethrow_exception(std::exchange(pending_error, nullptr));
}

void bind_task(nb::module_& m) {
  nb::class_<TaskRows>(m, "TaskRows",
                       "Rows of a task: A_a a + A_f f = b is wanted, missed as cheaply as weight "
                       "says.\n\nThe arrays are views: write into them, A_a[:] = ...")
      .def_prop_ro(
          "A_a", [](TaskRows& r) -> Eigen::Ref<Eigen::MatrixXd> { return r.A_a; },
          nb::rv_policy::reference_internal, "(rows, nv) on the acceleration, Pinocchio's order.")
      .def_prop_ro(
          "A_f", [](TaskRows& r) -> Eigen::Ref<Eigen::MatrixXd> { return r.A_f; },
          nb::rv_policy::reference_internal, "(rows, 12) on the contact forces, world axes.")
      .def_prop_ro(
          "b", [](TaskRows& r) -> Eigen::Ref<Eigen::VectorXd> { return r.b; },
          nb::rv_policy::reference_internal, "(rows,)")
      .def_prop_ro(
          "weight", [](TaskRows& r) -> Eigen::Ref<Eigen::VectorXd> { return r.weight; },
          nb::rv_policy::reference_internal, "(rows,) 0 or more; 1 to begin with.");
  nb::class_<Task, PythonTask>(m, "Task",
                               "A task of your own: subclass it and give it to add_task().\n\n"
                               "What write() raises stops the tick with BAD_TASK and is raised by "
                               "update().")
      .def(nb::init<>())
      .def("rows", &Task::rows, "How many rows it has; asked once.")
      .def("write", &Task::write, "state"_a, "rows"_a,
           "Write the rows for this state; they keep what was written the tick before.\n\n"
           "Return False to stop the tick with BAD_TASK.");
}
