// SPDX-License-Identifier: BSD-3-Clause
#include <nanobind/eigen/dense.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/trampoline.h>

#include "bindings.hpp"
#include "field_values.hpp"
#include "pending_error.hpp"
#include "planner_argument.hpp"
#include "surefoot/error.hpp"

using namespace nb::literals;
using namespace surefoot;

namespace {

/// Copy of a PlannerInput, so that a Python planner may keep it after its plan().
struct PlannerInputCopy {
  explicit PlannerInputCopy(const PlannerInput& input)
      : state(input.state),
        gains(input.gains),
        dt(input.dt),
        delay(input.delay),
        mass(input.mass),
        p_com(input.p_com),
        v_com(input.v_com),
        R_world_base(input.R_world_base),
        w_world_base(input.w_world_base),
        p_feet(input.p_feet),
        v_feet(input.v_feet),
        sole_sink(input.sole_sink),
        lost_leg(input.lost_leg) {}
  RobotState state;
  Gains gains;
  double dt, delay, mass;
  Vector3 p_com, v_com;
  Matrix3 R_world_base;
  Vector3 w_world_base;
  FeetMatrix p_feet, v_feet;
  Eigen::Vector4d sole_sink;
  int lost_leg;
};

/// Getter of a read-only view; def_ro() would make the view writable.
template <auto Member>
auto read_only(const PlannerInputCopy& input) {
  using Value = std::decay_t<decltype(input.*Member)>;
  return Eigen::Map<const Value>((input.*Member).data());
}

struct PythonPlanner : Planner {
  NB_TRAMPOLINE(Planner);
  bool plan(const PlannerInput& input, Reference& reference) noexcept override {
    try {
      constexpr std::uint64_t hash = nb::detail::str_hash("plan");
      const nb::detail::ticket ticket(nb_trampoline, "plan", hash, true);
      // Pass a pointer, so that Python writes into this reference and not into a copy.
      return lets_continue(
          nb_trampoline.base().attr(ticket.key)(PlannerInputCopy(input), &reference));
    } catch (...) {
      store_pending_error();
    }
    return false;
  }
  void reset() noexcept override {
    try {
      constexpr std::uint64_t hash = nb::detail::str_hash("reset");
      const nb::detail::ticket ticket(nb_trampoline, "reset", hash, true);
      nb_trampoline.base().attr(ticket.key)();
    } catch (...) {
      store_pending_error();
    }
  }
};

[[noreturn]] void refuse_base_method(const char* name) {
  throw Error(std::string("Planner.") + name +
              "(): got a call of the base class, expected one of a derived class; do not call it "
              "through super()");
}

void bind_planner_input(nb::module_& m) {
  nb::class_<PlannerInputCopy>(
      m, "PlannerInput",
      "What a planner sees of a tick: the estimated state, and kinematics computed from\n"
      "it.\n\n"
      "All quantities are in the world frame of `state`. Each call of plan() gets its\n"
      "own copy, which does not change later. Arrays are read-only.")
      .def_ro("state", &PlannerInputCopy::state, "Estimated state, a RobotState.")
      .def_ro("gains", &PlannerInputCopy::gains, "Gains of this tick.")
      .def_ro("dt", &PlannerInputCopy::dt, "Time since the last good tick [s].")
      .def_ro("delay", &PlannerInputCopy::delay,
              "Time from `state` until the command of this tick acts [s].\n\n"
              "The QP of a stepping robot uses the state predicted for that time, so its\n"
              "reference is planned for it too. See ControllerOptions.delay.")
      .def_ro("mass", &PlannerInputCopy::mass, "Mass of the robot [kg].")
      .def_prop_ro("p_com", &read_only<&PlannerInputCopy::p_com>, nb::rv_policy::reference_internal,
                   "Centre of mass [m], shape (3,).")
      .def_prop_ro("v_com", &read_only<&PlannerInputCopy::v_com>, nb::rv_policy::reference_internal,
                   "Velocity of the centre of mass [m/s], shape (3,).")
      .def_prop_ro(
          "R_world_base", &read_only<&PlannerInputCopy::R_world_base>,
          nb::rv_policy::reference_internal,
          "Rotation matrix from base to world axes, shape (3, 3). ``state.q[3:7]`` is the same\n"
          "orientation as a quaternion.")
      .def_prop_ro("w_world_base", &read_only<&PlannerInputCopy::w_world_base>,
                   nb::rv_policy::reference_internal,
                   "Angular velocity of the base [rad/s], world axes, shape (3,).")
      .def_prop_ro("p_feet", &read_only<&PlannerInputCopy::p_feet>,
                   nb::rv_policy::reference_internal,
                   "Contact points [m], shape (3, 4), FR FL RR RL.")
      .def_prop_ro("v_feet", &read_only<&PlannerInputCopy::v_feet>,
                   nb::rv_policy::reference_internal,
                   "Velocities of the contact points [m/s], shape (3, 4), FR FL RR RL.")
      .def_prop_ro(
          "sole_sink", &read_only<&PlannerInputCopy::sole_sink>, nb::rv_policy::reference_internal,
          "Depth by which each sole has yielded along the normal of the ground [m], shape\n"
          "(4,): the ground without load is higher than p_feet by it.")
      .def_ro("lost_leg", &PlannerInputCopy::lost_leg,
              "Leg that was given up, 0 .. 3, or -1. The controller plans no load for its foot,\n"
              "whatever the planner writes.");
}

}  // namespace

std::shared_ptr<Planner> planner_argument(nb::handle value) {
  constexpr FieldName kName{"Controller", "planner"};
  std::shared_ptr<Planner> planner;
  if (value.is_none() || !nb::try_cast(value, planner)) {
    refuse_value(kName, value,
                 "an object of a class derived from Planner, whose __init__() calls "
                 "super().__init__()");
  }
  const nb::handle base = nb::type<Planner>();
  for (const char* method : {"plan", "reset"}) {
    const bool missing = value.type().attr(method).is(base.attr(method));
    if (missing && dynamic_cast<PythonPlanner*>(planner.get()) != nullptr) {
      refuse_value(kName, value, std::string("a class that defines ") + method + "()");
    }
  }
  return planner;
}

void bind_planner(nb::module_& m) {
  bind_planner_input(m);
  nb::class_<Planner, PythonPlanner>(
      m, "Planner",
      "Base class of planners: a planner writes the Reference of each tick.\n\n"
      "Derive a class that defines plan() and reset(), and pass an object to Controller.\n"
      "See examples/custom_planner.py.")
      .def(nb::init<>(),
           "Create a planner; call this method from the __init__() of a derived class.")
      .def(
          "plan",
          [](Planner&, const PlannerInputCopy&, Reference&) -> bool { refuse_base_method("plan"); },
          "input"_a, "reference"_a,
          nb::sig("def plan(self, input: PlannerInput, reference: Reference) -> bool | None"),
          "Write the reference of this tick.\n\n"
          "Fields that are not written keep the values of the last valid reference. Before\n"
          "the first one, the reference is a default Reference with the standing pose as\n"
          "posture. Called in every tick with a good estimate of a robot that has not\n"
          "fallen. An exception ends the tick with BAD_REFERENCE; update() raises it after\n"
          "the tick.\n\n"
          "Args:\n"
          "    input: PlannerInput of this tick.\n"
          "    reference: Reference to write; valid during the call only.\n\n"
          "Returns:\n"
          "    False to end the tick with BAD_REFERENCE; True or None to continue. A number\n"
          "    that is not finite also ends the tick with BAD_REFERENCE. Then the tick tries\n"
          "    the fallback levels with the last valid reference.")
      .def(
          "reset", [](Planner&) { refuse_base_method("reset"); },
          "Forget everything: the next plan() is the first of a new start.\n\n"
          "Controller.reset() calls this method.");
}
