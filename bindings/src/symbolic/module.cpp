// SPDX-License-Identifier: BSD-3-Clause
#include <nanobind/nanobind.h>
#include <nanobind/stl/array.h>
#include <nanobind/stl/string.h>

#include "symbolic/leg_source.hpp"
#include "symbolic/robot_functions.hpp"

namespace nb = nanobind;
using namespace nb::literals;

NB_MODULE(_symbolic, m) {
  m.doc() = "Surefoot's models on CasADi; import surefoot.symbolic instead.";
  // Bytes: CasADi's text need not be UTF-8.
  m.def(
      "robot_function",
      [](const std::string& model, const std::array<int, 4>& feet, const std::string& name) {
        const std::string text = surefoot::symbolic::robot_function(model, feet, name);
        return nb::bytes(text.data(), text.size());
      },
      "model"_a, "feet"_a, "name"_a,
      "Serialise a casadi.Function of the robot whose serialised model this is.");
  m.def("leg_source", &surefoot::symbolic::leg_source,
        "Write controller/src/dynamics/generated/leg_dynamics.hpp anew.");
}
