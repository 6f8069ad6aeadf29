// SPDX-License-Identifier: BSD-3-Clause
#include <nanobind/eigen/dense.h>
#include <nanobind/stl/string.h>

#include "bindings.hpp"
#include "surefoot/walk_controller.hpp"
#include "value_class.hpp"

using namespace nb::literals;
using namespace surefoot;

namespace {

void bind_velocity(nb::module_& m) {
  ValueClass<WalkVelocity>(
      m, "WalkVelocity",
      "Velocity of a walking robot in its heading frame: x forward, y to the left, z up.")
      .def(
          "__init__",
          [](WalkVelocity* v, FieldArgument<double> vx, FieldArgument<double> vy,
             FieldArgument<double> yaw_rate) {
            constexpr const char* kType = "WalkVelocity";
            new (v) WalkVelocity{vx.to(kType, "vx"), vy.to(kType, "vy"),
                                 yaw_rate.to(kType, "yaw_rate")};
          },
          "vx"_a = 0.0, "vy"_a = 0.0, "yaw_rate"_a = 0.0,
          "Create a velocity; the arguments are the attributes.")
      .def_rw("vx", &WalkVelocity::vx, "Centre of mass, forward [m/s].")
      .def_rw("vy", &WalkVelocity::vy, "Centre of mass, to the left [m/s].")
      .def_rw("yaw_rate", &WalkVelocity::yaw_rate, "Turn to the left [rad/s].");
  nb::enum_<WalkLimit>(m, "WalkLimit", "Limit to which a commanded velocity was clamped.")
      .value("NONE", WalkLimit::kNone, "No limit: the command is within reach.")
      .value("FORWARD", WalkLimit::kForward,
             "vx: gains walk_speed_forward and walk_speed_backward; walk: walk_gait_speed.")
      .value("SIDEWAYS", WalkLimit::kSideways,
             "vy: gain walk_speed_sideways; walk: walk_gait_speed.")
      .value("TURN", WalkLimit::kTurn,
             "yaw_rate: gain walk_turn_speed; walk: walk_gait_turn_speed.")
      .value("COMBINATION", WalkLimit::kCombination,
             "All: the sum of the shares of the limits, or the acceleration in a curve.")
      .value("POWER", WalkLimit::kPower,
             "All: the power that ControllerOptions.power_limit allows.")
      .value("NOT_FINITE", WalkLimit::kNotFinite,
             "The command has a NaN or an infinity; the previous one stays in force.");
  nb::enum_<Gait>(m, "Gait", "What a WalkController does.")
      .value("AUTO", Gait::kAuto, "Stand at velocity 0, trot otherwise.")
      .value("TROT", Gait::kTrot, "Trot, also at velocity 0.")
      .value("WALK", Gait::kWalk,
             "Stand at velocity 0, walk otherwise: one foot steps at a time, three feet are down.");
}

void bind_options(nb::module_& m) {
  ValueClass<WalkOptions>(m, "WalkOptions",
                          "Options of a WalkController: fixed at construction, unlike gains.")
      .def(
          "__init__",
          [](WalkOptions* o, FieldArgument<ControllerOptions> tick,
             FieldArgument<double> velocity_timeout) {
            constexpr const char* kType = "WalkOptions";
            new (o)
                WalkOptions{tick.to(kType, "tick"), velocity_timeout.to(kType, "velocity_timeout")};
          },
          "tick"_a = ControllerOptions(), "velocity_timeout"_a = WalkOptions().velocity_timeout,
          "Create options; the arguments are the attributes.")
      .def_rw("tick", &WalkOptions::tick, "Options of the tick, a ControllerOptions.")
      .def_rw("velocity_timeout", &WalkOptions::velocity_timeout,
              "Age above which a commanded velocity becomes 0 [s], 0.01 .. 60.\n\n"
              "So the robot stops if the calling program ends.");
}

void bind_walk_controller(nb::module_& m) {
  nb::class_<WalkController, StandController>(
      m, "WalkController",
      "A StandController that also walks: LowState and a velocity in, LowCmd out.\n\n"
      "At velocity 0 it stands; with Gait.TROT it trots on the spot. At another velocity it "
      "trots,\n"
      "or with Gait.WALK walks with three feet down. Footholds follow the measured velocity, so\n"
      "steps brake pushes. Height, roll and pitch of set_body_reference() apply while it steps,\n"
      "relative to the standing pose. When the velocity is 0 again, it steps until it can stand "
      "in\n"
      "the nominal stance. With a lost leg it only stands.")
      .def(
          "__init__",
          [](WalkController* self, const Robot& robot, const Gains* gains,
             const WalkOptions& options) {
            new (self) WalkController(robot, gains ? *gains : robot.config().gains, options);
          },
          "robot"_a, "gains"_a.none() = nb::none(), "options"_a = WalkOptions(),
          "Create a controller for a robot.\n\n"
          "Raises Error if the robot does not have twelve joints on a free base, if it cannot\n"
          "walk (see can_walk), or if a gain or an option is invalid.\n\n"
          "Args:\n"
          "    robot: The robot.\n"
          "    gains: Gains; None: those of the robot.\n"
          "    options: Options, fixed from now on.")
      .def("set_velocity", &WalkController::set_velocity, "velocity"_a,
           "Command a WalkVelocity; call it more often than WalkOptions.velocity_timeout.\n\n"
           "The velocity is clamped to the gains walk_speed_forward, walk_speed_backward,\n"
           "walk_speed_sideways and walk_turn_speed; in the gait WALK to walk_gait_speed and\n"
           "walk_gait_turn_speed. Then all three are reduced to what can be combined, and\n"
           "to what the power limit carries. A velocity with a NaN or an infinity is\n"
           "ignored. velocity_limit has the last limit that acted, or NOT_FINITE. Real-time:\n"
           "yes.")
      .def_prop_ro("commanded_velocity", &WalkController::commanded_velocity,
                   "Velocity that is commanded, clamped; 0 after the timeout.")
      .def_prop_ro("reference_velocity", &WalkController::reference_velocity,
                   "Velocity of the reference, which approaches commanded_velocity.")
      .def_prop_ro("velocity_limit", &WalkController::velocity_limit,
                   "WalkLimit that reduced the commanded velocity, in the present gait.")
      .def_prop_rw("gait", &WalkController::gait, &WalkController::set_gait,
                   "Gait; a change is in force from the next tick on.")
      .def_prop_ro("walking", &WalkController::walking, "Whether the last tick planned steps.")
      .def_prop_ro("velocity_expired", &WalkController::velocity_expired,
                   "Whether the last velocity is older than WalkOptions.velocity_timeout, or none\n"
                   "was set since reset().")
      .def_prop_ro("can_walk", &WalkController::can_walk,
                   "Whether the motors can carry the robot in the standing pose on two diagonal\n"
                   "feet, with at most 0.8 of their torque limits.\n\n"
                   "If not, the controller only stands; only a Supervisor has such a controller.")
      .def_prop_ro("footholds", &WalkController::footholds,
                   "Footholds FR FL RR RL, world frame of state [m], shape (3, 4): where each\n"
                   "foot lands or has landed.")
      .def_prop_ro("planned_loads", &WalkController::planned_loads,
                   "Planned loads FR FL RR RL, 0 .. 1, shape (4,); 0: the foot swings.");
}

}  // namespace

void bind_walk(nb::module_& m) {
  bind_velocity(m);
  bind_options(m);
  bind_walk_controller(m);
}
