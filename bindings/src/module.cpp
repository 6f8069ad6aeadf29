// SPDX-License-Identifier: BSD-3-Clause
#include "bindings.hpp"
#include "surefoot/error.hpp"

namespace nb = nanobind;

NB_MODULE(_core, m) {
  // A task written in Python and the controller that holds it may outlive the interpreter together.
  nb::set_leak_warnings(false);
  m.doc() = "Surefoot's C++ core; import surefoot instead.";
  nb::exception<surefoot::Error>(m, "Error").doc() =
      "Raised while building, loading or configuring, never by a tick.\n\n"
      "The message says what is wrong, what was got, what was expected, and the valid names.";
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
