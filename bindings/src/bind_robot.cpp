// SPDX-License-Identifier: BSD-3-Clause
#include <nanobind/eigen/dense.h>
#include <nanobind/operators.h>
#include <nanobind/stl/array.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/string_view.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include "bindings.hpp"
#include "surefoot/error.hpp"
#include "surefoot/robot.hpp"

namespace nb = nanobind;
using namespace nb::literals;
using namespace surefoot;

namespace {

void bind_gains(nb::module_& m) {
  nb::class_<GainInfo>(m, "GainInfo", "One row of gain_table().")
      .def_prop_ro(
          "group", [](const GainInfo& i) { return std::string(i.group); },
          "What it belongs to: Body, Feet, Joints, ...")
      .def_prop_ro(
          "name", [](const GainInfo& i) { return std::string(i.name); }, "Attribute of Gains.")
      .def_prop_ro(
          "unit", [](const GainInfo& i) { return std::string(i.unit); }, "Unit of the value.")
      .def_prop_ro(
          "minimum", [](const GainInfo& i) { return i.minimum; }, "Least valid value.")
      .def_prop_ro(
          "maximum", [](const GainInfo& i) { return i.maximum; }, "Greatest valid value.")
      .def_prop_ro(
          "default", [](const GainInfo& i) { return Gains().*i.member; }, "Library default.")
      .def_prop_ro(
          "meaning", [](const GainInfo& i) { return std::string(i.meaning); }, "What it does.");
  nb::class_<Gains> gains(
      m, "Gains", "Everything that can be tuned; gain_table() says unit, range and meaning.");
  gains.def(nb::init<>());
  for (const GainInfo& info : gain_table()) {
    const auto member = info.member;
    const std::string doc = std::string(info.meaning) + " [" + std::string(info.unit) + "].";
    gains.def_prop_rw(
        std::string(info.name).c_str(), [member](const Gains& g) { return g.*member; },
        [member](Gains& g, double value) { g.*member = value; }, doc.c_str());
  }
  gains.def("validate", &Gains::validate, "Raise Error naming the first gain out of range or NaN.");
  gains.def("__copy__", [](const Gains& g) { return Gains(g); });
  gains.def("__eq__", [](const Gains& a, const Gains& b) { return a == b; }, nb::is_operator());
  m.def(
      "gain_table",
      [] {
        std::vector<GainInfo> rows;
        for (const GainInfo& info : gain_table()) rows.push_back(info);
        return rows;
      },
      "List every gain: name, unit, range, default, meaning.");
  m.def("get_gain", &get_gain, "gains"_a, "name"_a,
        "Read a gain by name; raises Error with valid names.");
  m.def("set_gain", &set_gain, "gains"_a, "name"_a, "value"_a,
        "Write a gain by name; raises Error on an unknown name or a value out of range.");
}

void bind_config(nb::module_& m) {
  nb::class_<RobotConfig>(m, "RobotConfig",
                          "What a robot is beyond its kinematics and masses.\n\n"
                          "Twelve values run in SDK motor order, four in leg order FR FL RR RL.")
      .def(nb::init<>())
      .def_rw("name", &RobotConfig::name, "One word.")
      .def_rw("joint_names", &RobotConfig::joint_names, "12 names, SDK motor order.")
      .def_rw("foot_frames", &RobotConfig::foot_frames, "4 frame names, FR FL RR RL.")
      .def_rw("foot_radius", &RobotConfig::foot_radius, "[m].")
      .def_rw("p_base_imu", &RobotConfig::p_base_imu, "IMU origin in the base frame [m].")
      .def_rw("quat_base_imu", &RobotConfig::quat_base_imu, "w x y z; maps IMU axes to base axes.")
      .def_rw("q_lower", &RobotConfig::q_lower, "[rad] SDK and URDF limits, intersected.")
      .def_rw("q_upper", &RobotConfig::q_upper, "[rad] SDK and URDF limits, intersected.")
      .def_rw("hip_inward", &RobotConfig::hip_inward,
              "[rad] that hips may turn legs under the trunk: motion_range().")
      .def_rw("dq_max", &RobotConfig::dq_max, "[rad/s].")
      .def_rw("tau_max", &RobotConfig::tau_max, "[N.m] up to corner_speed.")
      .def_rw("corner_speed", &RobotConfig::corner_speed, "[rad/s] torque starts to fall here.")
      .def_rw("no_load_speed", &RobotConfig::no_load_speed, "[rad/s] torque has vanished here.")
      .def_rw("armature", &RobotConfig::armature, "Reflected rotor inertia [kg.m^2].")
      .def_rw("q_standing", &RobotConfig::q_standing, "Standing pose [rad].")
      .def_rw("friction", &RobotConfig::friction, "Coefficient that the controller assumes.")
      .def_rw("gains", &RobotConfig::gains, "This robot's default gains.")
      .def("validate", &RobotConfig::validate, "Raise Error naming the field that is wrong.");
  m.def(
      "motion_range",
      [](const RobotConfig& config, int motor) {
        if (motor < 0 || motor >= kMotors) {
          throw Error("motion_range: got motor " + std::to_string(motor) + ", expected 0 .. 11");
        }
        const JointRange range = motion_range(config, motor);
        return std::make_tuple(range.lower, range.upper);
      },
      "config"_a, "motor"_a,
      "Where the program takes a motor, and a body reference: (lower, upper) [rad].\n\n"
      "q_lower .. q_upper, a hip no further inward than hip_inward. Raises Error.");
  m.def("motor_torque_limit", &motor_torque_limit, "config"_a, "motor"_a, "dq"_a, "sign"_a,
        "Greatest torque [N.m] of a motor in the direction of sign at joint velocity dq [rad/s].");
}

}  // namespace

void bind_robot(nb::module_& m) {
  bind_gains(m);
  bind_config(m);
  nb::class_<Robot>(
      m, "Robot",
      "A robot: the part that never changes. Cheap to copy, safe to share.\n\n"
      "q and v are Pinocchio's: [position, quaternion x y z w, joints] and [base twist in\n"
      "base axes, joint velocities], joints in Pinocchio's order.")
      .def_static("from_serialized_model", &Robot::from_serialized_model, "text"_a, "config"_a,
                  "Build from pinocchio.Model.saveToString() text; the versions must agree.")
      .def_static("load", &Robot::load, "path"_a, "Read a .robot file; raises Error.")
      .def("save", &Robot::save, "path"_a, "Write a .robot file that C++ and Python read alike.")
      .def("serialized_model", &Robot::serialized_model,
           "Return the model as text for pinocchio.Model.loadFromString().")
      .def_prop_ro(
          "config", [](const Robot& r) { return RobotConfig(r.config()); },
          "A copy of the configuration.")
      .def_prop_ro(
          "name", [](const Robot& r) { return r.config().name; }, "Name of the robot.")
      .def_prop_ro("nq", &Robot::nq, "Size of q.")
      .def_prop_ro("nv", &Robot::nv, "Size of v.")
      .def_prop_ro("mass", &Robot::mass, "Total mass [kg].")
      .def_prop_ro("motor_to_v", &Robot::motor_to_v, "Index in v of each SDK motor.")
      .def_prop_ro("motor_to_q", &Robot::motor_to_q, "Index in q of each SDK motor.")
      .def_prop_ro("foot_frame_ids", &Robot::foot_frame_ids,
                   "Pinocchio frame of each foot, FR FL RR RL.")
      .def("q_standing", &Robot::q_standing, "q with the base level at the origin, standing pose.");
}
