// SPDX-License-Identifier: BSD-3-Clause
#include "bindings.hpp"
#include "surefoot/error.hpp"

namespace nb = nanobind;

NB_MODULE(_core, m) {
  // A Python task and the controller that holds it may both outlive the interpreter.
  nb::set_leak_warnings(false);
  m.doc() =
      "C++ core of Surefoot; import surefoot instead.\n\n"
      "Real-time marks in these docstrings apply to the C++ functions; calls from\n"
      "Python allocate. An object that is called a copy does not change with later\n"
      "ticks. Its arrays are numpy views of that object.";
  nb::exception<surefoot::Error>(m, "Error").doc() =
      "Error while building, loading or configuring. A tick never raises it.\n\n"
      "The message says what is wrong, what was got, what was expected, and which names\n"
      "are valid.";
  bind_low_level(m);
  bind_frames(m);
  bind_robot(m);
  bind_types(m);
  bind_task(m);
  bind_whole_body(m);
  bind_estimator(m);
  bind_stand(m);
  bind_link(m);
  bind_safety(m);
  bind_supervisor(m);
  bind_run_log(m);
  bind_run(m);
}
