// SPDX-License-Identifier: BSD-3-Clause
#include <nanobind/stl/array.h>
#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/string_view.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include <filesystem>

#include "bindings.hpp"
#include "surefoot/error.hpp"
#include "surefoot/robot.hpp"
#include "value_class.hpp"

using namespace nb::literals;
using namespace surefoot;

namespace {

void bind_gains(nb::module_& m) {
  nb::class_<GainInfo>(m, "GainInfo", "One row of gain_table().")
      .def_prop_ro(
          "group", [](const GainInfo& i) { return std::string(i.group); },
          "Part of the controller, such as Body, Feet or Joints.")
      .def_prop_ro(
          "name", [](const GainInfo& i) { return std::string(i.name); },
          "Name of the attribute of Gains.")
      .def_prop_ro(
          "unit", [](const GainInfo& i) { return std::string(i.unit); },
          "Unit of the value, such as 1/s^2; 1 means dimensionless.")
      .def_prop_ro(
          "minimum", [](const GainInfo& i) { return i.minimum; }, "Smallest valid value.")
      .def_prop_ro(
          "maximum", [](const GainInfo& i) { return i.maximum; }, "Largest valid value.")
      .def_prop_ro(
          "default", [](const GainInfo& i) { return Gains().*i.member; },
          "Default of the library, in the same unit.")
      .def_prop_ro(
          "meaning", [](const GainInfo& i) { return std::string(i.meaning); },
          "Meaning of the gain, in a phrase.")
      .def("__repr__", [](const GainInfo& i) {
        return "GainInfo(name='" + std::string(i.name) + "', unit='" + std::string(i.unit) + "')";
      });
  ValueClass<Gains> gains(
      m, "Gains",
      "Parameters of standing that are tuned per robot.\n\n"
      "gain_table() has unit, range and meaning of every gain. Gains() has the\n"
      "library's defaults; RobotConfig.gains has the values of one robot. Stiffness and\n"
      "damping are per unit of inertia, so their values are similar on all robots. The\n"
      "unit m g is the weight of the robot.");
  gains.def(nb::init<>(), "Create the library's defaults.");
  for (const GainInfo& info : gain_table()) {
    const auto member = info.member;
    const std::string doc = std::string(info.meaning) + " [" + std::string(info.unit) + "].";
    gains.def_rw(std::string(info.name).c_str(), member, doc.c_str());
  }
  gains.def("validate", &Gains::validate,
            "Raise Error if a gain is not finite or outside its range.\n\n"
            "Also raise Error if contact_force_off is not below contact_force_on. The message\n"
            "names the first invalid gain.");
  m.def(
      "gain_table",
      [] {
        std::vector<GainInfo> rows;
        for (const GainInfo& info : gain_table()) rows.push_back(info);
        return rows;
      },
      "Return a GainInfo for every gain, in the order of Gains.");
  m.def("get_gain", &get_gain, "gains"_a, "name"_a,
        "Return a gain by name. Raises Error if the name is unknown; the message lists\n"
        "the nearest names.");
  m.def("set_gain", &set_gain, "gains"_a, "name"_a, "value"_a,
        "Set a gain by name.\n\n"
        "Raises Error if the name is unknown, or the value is not finite or out of range.");
}

void bind_config(nb::module_& m) {
  ValueClass<RobotConfig>(
      m, "RobotConfig",
      "Properties of a robot that its kinematic and inertial model does not have.\n\n"
      "Arrays of twelve are in SDK motor order (FR FL RR RL; hip, thigh, calf), arrays\n"
      "of four in leg order. Numeric arrays are writable numpy views; lists of names\n"
      "are copies.")
      .def(nb::init<>(), "Create an empty configuration, to be filled in.")
      .def_rw("name", &RobotConfig::name, "Name of the robot, one word.")
      .def_rw("joint_names", &RobotConfig::joint_names,
              "Names of the 12 joints in the model, SDK motor order.")
      .def_rw("foot_frames", &RobotConfig::foot_frames,
              "Names of the 4 foot frames in the model, FR FL RR RL.")
      .def_rw("foot_radius", &RobotConfig::foot_radius,
              "Radius of the foot [m], a sphere about the origin of the foot frame.")
      .def_rw("p_base_imu", &RobotConfig::p_base_imu,
              "IMU origin in the base frame [m], shape (3,).")
      .def_rw("quat_base_imu", &RobotConfig::quat_base_imu,
              "Quaternion w x y z, IMU axes to base axes, shape (4,).")
      .def_rw("q_lower", &RobotConfig::q_lower,
              "Lower position limits [rad], shape (12,), the narrower of SDK and URDF.")
      .def_rw("q_upper", &RobotConfig::q_upper,
              "Upper position limits [rad], shape (12,), the narrower of SDK and URDF.")
      .def_rw("hip_inward", &RobotConfig::hip_inward,
              "Largest inward angle of every hip [rad], > 0, see motion_range().")
      .def_rw("dq_max", &RobotConfig::dq_max, "Velocity limits [rad/s], shape (12,).")
      .def_rw("tau_max", &RobotConfig::tau_max,
              "Torque limits [N.m] up to corner_speed, shape (12,).")
      .def_rw("corner_speed", &RobotConfig::corner_speed,
              "Velocity at which the torque limit starts to fall [rad/s], shape (12,).")
      .def_rw("no_load_speed", &RobotConfig::no_load_speed,
              "Velocity at which the torque limit reaches zero [rad/s], shape (12,).")
      .def_rw("armature", &RobotConfig::armature,
              "Rotor inertia times squared gear ratio [kg.m^2], shape (12,).")
      .def_rw("q_standing", &RobotConfig::q_standing,
              "Joint angles of the standing pose [rad], shape (12,).")
      .def_rw("friction", &RobotConfig::friction,
              "Friction coefficient that the controller assumes between foot and ground.")
      .def_rw("gains", &RobotConfig::gains, "Default gains of this robot.")
      .def("validate", &RobotConfig::validate,
           "Raise Error if a field is invalid; the message names the field.");
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
      "Compute the range within which QP and body reference keep a motor.\n\n"
      "Returns the pair (lower, upper) [rad]. The range is q_lower .. q_upper. For a\n"
      "hip it also ends at hip_inward. Beyond that angle the trunk rests on the thigh,\n"
      "and the dynamics do not model this contact. Arming checks and protections use\n"
      "q_lower and q_upper instead, because an external force may push a hip beyond\n"
      "hip_inward. Raises Error unless motor is 0 .. 11. Real-time: yes.");
  m.def("motor_torque_limit", &motor_torque_limit, "config"_a, "motor"_a, "dq"_a, "sign"_a,
        "Compute the largest torque [N.m] of a motor in the direction of sign at joint\n"
        "velocity dq [rad/s].\n\n"
        "While torque and velocity have the same sign, the limit is tau_max up to\n"
        "corner_speed, then falls linearly to zero at no_load_speed. A braking motor\n"
        "keeps tau_max. The result is not negative. motor must be 0 .. 11. Real-time:\n"
        "yes.");
}

bool equal_robots(const Robot& a, const Robot& b) {
  if (&a.config() == &b.config()) return true;  // copies share their data
  return nb::cast(RobotConfig(a.config())).equal(nb::cast(RobotConfig(b.config()))) &&
         a.serialized_model() == b.serialized_model();
}

// A robot is immutable: a copy is the robot itself, and equal robots have equal hashes.
void def_value_methods(nb::class_<Robot>& c) {
  c.def("__copy__", [](const Robot& r) { return Robot(r); })
      .def(
          "__deepcopy__", [](const Robot& r, const nb::dict&) { return Robot(r); }, "memo"_a)
      .def(
          "__eq__",
          [](const Robot& a, nb::handle b) {
            return nb::isinstance<Robot>(b) && equal_robots(a, nb::cast<const Robot&>(b));
          },
          nb::sig("def __eq__(self, other: object, /) -> bool"))
      .def("__hash__",
           [](const Robot& r) { return nb::hash(nb::make_tuple(r.config().name, r.mass())); })
      .def("__getstate__",
           [](const Robot& r) {
             return nb::make_tuple(r.serialized_model(), RobotConfig(r.config()));
           })
      .def("__setstate__",
           [](Robot* self, const std::tuple<std::string, RobotConfig>& state) {
             new (self) Robot(Robot::from_serialized_model(std::get<0>(state), std::get<1>(state)));
           })
      .def("__repr__", [](const Robot& r) {
        return "Robot(name='" + r.config().name + "', mass=" + value_text(nb::float_(r.mass())) +
               ", nq=" + std::to_string(r.nq()) + ")";
      });
}

void bind_robot_class(nb::module_& m) {
  nb::class_<Robot> robot(
      m, "Robot",
      "Model and configuration of a robot. Immutable, cheap to copy, and safe to share\n"
      "between threads.\n\n"
      "q and v follow Pinocchio: q = [p_world_base, quaternion x y z w, joints], v =\n"
      "[linear and angular velocity of the base in base axes, joint velocities]. Joints\n"
      "in q and v are in Pinocchio's order, which differs from SDK motor order: convert\n"
      "with motor_to_q and motor_to_v. Joints are matched to motors by name.");
  robot
      .def_static("from_serialized_model", &Robot::from_serialized_model, "text"_a, "config"_a,
                  "Build a Robot from the text that pinocchio.Model.saveToString() returned.\n\n"
                  "Both sides need the same Pinocchio version. RobotConfig.armature replaces the\n"
                  "armature of the model.\n\n"
                  "Raises Error if the text cannot be read, or if the configuration is invalid or\n"
                  "does not fit the model.")
      .def_static(
          "load", [](const std::filesystem::path& path) { return Robot::load(path.string()); },
          "path"_a,
          "Read a .robot file that save() wrote. No URDF parser and no meshes are needed.\n\n"
          "Raises Error if the file cannot be read, is damaged, or has another version.")
      .def(
          "save", [](const Robot& r, const std::filesystem::path& path) { r.save(path.string()); },
          "path"_a,
          "Write a .robot file, which C++ and Python can read. Raises Error if the file\n"
          "cannot be written.")
      .def("serialized_model", &Robot::serialized_model,
           "Return the model as text for pinocchio.Model.loadFromString() of the same\n"
           "version.")
      .def_prop_ro(
          "config", [](const Robot& r) { return RobotConfig(r.config()); },
          "Configuration of the robot, a copy.")
      .def_prop_ro(
          "name", [](const Robot& r) { return r.config().name; }, "Name of the robot.")
      .def_prop_ro("nq", &Robot::nq, "Size of q; 19 for a robot with twelve joints.")
      .def_prop_ro("nv", &Robot::nv, "Size of v; 18 for a robot with twelve joints.")
      .def_prop_ro("mass", &Robot::mass, "Total mass [kg].")
      .def_prop_ro("doubts", &Robot::doubts,
                   "Values of model and configuration that are possible but unusual, a list of\n"
                   "sentences.")
      .def_prop_ro("motor_to_v", &Robot::motor_to_v, "Index in v of each SDK motor, 12 integers.")
      .def_prop_ro("motor_to_q", &Robot::motor_to_q, "Index in q of each SDK motor, 12 integers.")
      .def_prop_ro("foot_frame_ids", &Robot::foot_frame_ids,
                   "Pinocchio frame id of each foot, 4 integers, FR FL RR RL.")
      .def("q_standing", &Robot::q_standing,
           "Return q of the standing pose, shape (nq,), with the base level at the world\n"
           "origin.");
  def_value_methods(robot);
}

}  // namespace

void bind_robot(nb::module_& m) {
  bind_gains(m);
  bind_config(m);
  bind_robot_class(m);
}
