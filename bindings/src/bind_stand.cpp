// SPDX-License-Identifier: BSD-3-Clause
#include <nanobind/stl/string.h>

#include "bindings.hpp"
#include "surefoot/stand_controller.hpp"
#include "value_class.hpp"

using namespace nb::literals;
using namespace surefoot;

namespace {

void bind_body_reference(nb::module_& m) {
  ValueClass<BodyReference>(
      m, "BodyReference",
      "Pose of the body relative to the latched pose; all zero is the latched pose.\n\n"
      "Displacement of the base origin along the axes of the support frame (x forward,\n"
      "y left, z out of the ground), and orientation in that frame: R = Rz(yaw)\n"
      "Ry(pitch) Rx(roll) R_latched.")
      .def(
          "__init__",
          [](BodyReference* r, FieldArgument<double> x, FieldArgument<double> y,
             FieldArgument<double> height, FieldArgument<double> roll, FieldArgument<double> pitch,
             FieldArgument<double> yaw) {
            constexpr const char* kType = "BodyReference";
            new (r) BodyReference{x.to(kType, "x"),           y.to(kType, "y"),
                                  height.to(kType, "height"), roll.to(kType, "roll"),
                                  pitch.to(kType, "pitch"),   yaw.to(kType, "yaw")};
          },
          "x"_a = 0.0, "y"_a = 0.0, "height"_a = 0.0, "roll"_a = 0.0, "pitch"_a = 0.0,
          "yaw"_a = 0.0, "Create a pose; the arguments are the attributes.")
      .def_rw("x", &BodyReference::x, "Displacement forward [m].")
      .def_rw("y", &BodyReference::y, "Displacement to the left [m].")
      .def_rw("height", &BodyReference::height,
              "Displacement along the ground normal, out of the ground [m].")
      .def_rw("roll", &BodyReference::roll, "Rotation about x, forward [rad].")
      .def_rw("pitch", &BodyReference::pitch, "Rotation about y, to the left [rad].")
      .def_rw("yaw", &BodyReference::yaw, "Rotation about z, the ground normal [rad].");
  nb::enum_<ReachLimit>(m, "ReachLimit", "Limit that stops the body reference before its target.")
      .value("NONE", ReachLimit::kNone,
             "No limit; the reference is at the target or moves towards it.")
      .value("JOINT", ReachLimit::kJoint,
             "A joint would come closer than the gain reach_joint_margin to an end of its\n"
             "motion_range().")
      .value("SUPPORT", ReachLimit::kSupport,
             "The centre of mass would come closer than the gain reach_support_margin to a\n"
             "support edge.")
      .value("FOOT_HEIGHT", ReachLimit::kFootHeight,
             "A foot would be less than the gain reach_foot_depth below its hip axis.")
      .value("UNREACHABLE", ReachLimit::kUnreachable,
             "A leg is too short to reach its foot position.")
      .value("NOT_FINITE", ReachLimit::kNotFinite,
             "The target has a NaN or an infinity. The previous target stays in force.");
  ValueClass<ReachStatus>(m, "ReachStatus", "Limit that stops the body reference, and its motor.")
      .def_ro("limit", &ReachStatus::limit, "Limit that stops the reference, or NONE.")
      .def_ro("motor", &ReachStatus::motor,
              "SDK number of the joint (JOINT) or of the hip of the leg (FOOT_HEIGHT); -1 for\n"
              "other limits.");
}

}  // namespace

void bind_stand(nb::module_& m) {
  bind_body_reference(m);
  nb::class_<StandController, Controller>(
      m, "StandController",
      "Controller that holds the body at the latched pose, or moves it to a\n"
      "BodyReference.\n\n"
      "Its planner latches the pose of the body relative to the feet in the first good\n"
      "samples. After a strong push the robot steps (gain recovery_margin), until its feet are\n"
      "in the nominal stance, and latches the pose in which it stands. After a lost leg, it\n"
      "moves the centre of mass over the other three feet. It estimates the normal of the\n"
      "ground plane under the feet.")
      .def(
          "__init__",
          [](StandController* self, const Robot& robot, const Gains* gains,
             const ControllerOptions& options) {
            new (self) StandController(robot, gains ? *gains : robot.config().gains, options);
          },
          "robot"_a, "gains"_a = nb::none(), "options"_a = ControllerOptions(),
          "Create a controller.\n\n"
          "Args:\n"
          "    robot: Model and configuration, twelve joints on a free base.\n"
          "    gains: Gains to use; None: robot.config.gains.\n"
          "    options: Options, fixed at construction.\n\n"
          "Raises:\n"
          "    Error: The robot does not have twelve joints on a free base, or a gain or an\n"
          "        option is invalid.")
      .def("set_body_reference", &StandController::set_body_reference, "target"_a,
           "Set the target pose of the body; reset() clears it.\n\n"
           "The reference moves to the target with limited speed and acceleration, and stops\n"
           "at the limits of ReachLimit. A target with a NaN or an infinity is ignored, and\n"
           "reach reports NOT_FINITE. Real-time: yes.")
      .def_prop_ro("body_reference", &StandController::body_reference,
                   "Present body reference, which moves towards the target.")
      .def_prop_ro("reach", &StandController::reach,
                   "Limit that stops the body reference before its target, a ReachStatus.")
      .def("capture_margin_without", &StandController::capture_margin_without, "leg"_a,
           "Compute the distance [m] from the capture point to the nearest edge of the\n"
           "support triangle that remains without `leg`.\n\n"
           "The newest state estimate is used. Negative: outside the triangle. +inf: another\n"
           "leg is already lost. NaN: leg is not 0 .. 3, or no pose is latched yet.\n"
           "Real-time: yes.");
}
