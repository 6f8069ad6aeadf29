// SPDX-License-Identifier: BSD-3-Clause
#include "bindings.hpp"
#include "surefoot/error.hpp"

namespace nb = nanobind;

NB_MODULE(_core, m) {
  m.doc() = "Surefoot's C++ core; import surefoot instead.";
  nb::exception<surefoot::Error>(m, "Error").doc() =
      "Raised while building, loading or configuring, never by a tick.\n\n"
      "The message says what is wrong, what was got, what was expected, and the valid names.";
  bind_low_level(m);
  bind_robot(m);
  bind_control(m);
}
