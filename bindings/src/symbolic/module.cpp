// SPDX-License-Identifier: BSD-3-Clause
#include <nanobind/nanobind.h>
#include <nanobind/stl/array.h>
#include <nanobind/stl/string.h>

#include "symbolic/leg_source.hpp"
#include "symbolic/robot_functions.hpp"

namespace nb = nanobind;
using namespace nb::literals;

NB_MODULE(_symbolic, m) {
  m.doc() = "CasADi functions of robot models; import surefoot.symbolic instead.";
  // Return bytes, because CasADi's text need not be UTF-8.
  m.def(
      "robot_function",
      [](const std::string& model, const std::array<int, 4>& feet, const std::string& name) {
        const std::string text = surefoot::symbolic::robot_function(model, feet, name);
        return nb::bytes(text.data(), text.size());
      },
      "model"_a, "feet"_a, "name"_a,
      "Return a serialised casadi.Function of a robot, from the robot's serialised model.");
  m.def("leg_source", &surefoot::symbolic::leg_source,
        "Return the text of controller/src/dynamics/generated/leg_dynamics.hpp.");
}
