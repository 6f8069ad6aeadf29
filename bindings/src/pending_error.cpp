// SPDX-License-Identifier: BSD-3-Clause
#include "pending_error.hpp"

#include <exception>
#include <utility>

namespace nb = nanobind;

namespace {
thread_local std::exception_ptr pending_error;
}

void store_pending_error() noexcept {
  if (!pending_error) pending_error = std::current_exception();
}

void raise_pending_error() {
  if (pending_error) std::rethrow_exception(std::exchange(pending_error, nullptr));
}

bool lets_continue(nb::handle answer) {
  if (answer.is_none()) return true;
  const int truth = PyObject_IsTrue(answer.ptr());
  if (truth < 0) throw nb::python_error();
  return truth == 1;
}
