// SPDX-License-Identifier: BSD-3-Clause
#include "bindings.hpp"
#include "surefoot/error.hpp"

namespace nb = nanobind;

NB_MODULE(_core, m) {
  // A Python task or planner and its controller may refer to each other, so both may still exist
  // when the interpreter exits. nanobind would report this as a leak.
  nb::set_leak_warnings(false);
  m.doc() =
      "C++ core of Surefoot; import surefoot instead.\n\n"
      "Real-time marks in these docstrings apply to the C++ functions; calls from\n"
      "Python allocate. Docstrings mark some objects as copies: a copy does not change\n"
      "with later ticks. The arrays of a copy are numpy views of the copy.";
  nb::exception<surefoot::Error>(m, "Error").doc() =
      "Error while a robot or a controller is built, loaded or configured. A tick never\n"
      "raises this error.\n\n"
      "The message says what is wrong, what was got, what was expected, and which names\n"
      "are valid.";
  bind_low_level(m);
  bind_frames(m);
  bind_robot(m);
  bind_types(m);
  bind_task(m);
  bind_planner(m);
  bind_whole_body(m);
  bind_estimator(m);
  bind_controller(m);
  bind_stand(m);
  bind_walk(m);
  bind_link(m);
  bind_dds_network(m);
  bind_dds_link(m);
  bind_dds_robot_port(m);
  bind_dds_service(m);
  bind_safety(m);
  bind_supervisor(m);
  bind_run_log(m);
  bind_run(m);
}
