// SPDX-License-Identifier: BSD-3-Clause
#include <nanobind/eigen/dense.h>
#include <nanobind/stl/string.h>

#include "bindings.hpp"
#include "surefoot/error.hpp"
#include "surefoot/types.hpp"

namespace nb = nanobind;
using namespace nb::literals;
using namespace surefoot;

namespace {

void bind_status(nb::module_& m) {
  nb::enum_<Status>(m, "Status",
                    "Result of a tick. update() returns errors as a Status and\n"
                    "never raises.")
      .value("OK", Status::kOk, "A command, or a solution, was computed.")
      .value("WAITING", Status::kWaiting, "No valid sample has arrived yet, or no tick has run.")
      .value("NON_FINITE", Status::kNonFinite,
             "A field that is read is NaN or infinite. In a LowState, also if its magnitude\n"
             "exceeds 1e4.")
      .value("IMPLAUSIBLE", Status::kImplausible,
             "A field that is read is beyond what the robot can do or measure.")
      .value("FALLEN", Status::kFallen, "The base is tilted beyond the gain fall_tilt.")
      .value("BAD_REFERENCE", Status::kBadReference,
             "The quaternion or the ground normal of the reference is not of unit length, or\n"
             "the normal does not point up.")
      .value("WRONG_SIZE", Status::kWrongSize,
             "q, v or the posture does not have the robot's size.")
      .value("BAD_QUATERNION", Status::kBadQuaternion,
             "The quaternion of the IMU or of q is zero or far from unit length.")
      .value("STALE_TICK", Status::kStaleTick, "LowState.tick did not advance, or jumped ahead.")
      .value("MAX_ITERATIONS", Status::kMaxIterations,
             "The solver found no solution with small enough residuals.")
      .value("INFEASIBLE", Status::kInfeasible, "The solver reported that the QP is infeasible.")
      .value("SINGULAR", Status::kSingular,
             "Condensed form: a leg is nearly straight, or a foot near hip height.")
      .value("DAMPING", Status::kDamping, "Damping is latched: the motors damp until reset().")
      .value("BAD_TASK", Status::kBadTask,
             "A custom task failed, or wrote invalid rows or rows with too large weights.")
      .value("SATURATED", Status::kSaturated,
             "The command may be sent; a motor or the power is at its limit.")
      .value("DIVERGED", Status::kDiverged,
             "The state estimate diverged: no motion explains the samples.")
      .value("WRONG_GYROSCOPE", Status::kWrongGyroscope,
             "The gyroscope has been wrong since the first sample: expected rad/s, IMU axes.")
      .value("WRONG_ACCELEROMETER", Status::kWrongAccelerometer,
             "The accelerometer has been wrong since the first sample: expected m/s^2, IMU axes,\n"
             "+9.81 upwards at rest.")
      .value("WRONG_JOINT_ANGLES", Status::kWrongJointAngles,
             "q has been wrong since the first sample: expected rad, order and signs of the SDK.")
      .value("WRONG_JOINT_VELOCITIES", Status::kWrongJointVelocities,
             "dq has been wrong since the first sample: expected rad/s, order and signs of the\n"
             "SDK.")
      .value("WRONG_JOINT_TORQUES", Status::kWrongJointTorques,
             "tauEst has been wrong since the first sample: expected N.m, order and signs of the\n"
             "SDK.");
  m.def("is_usable", &is_usable, "status"_a,
        "Return whether a tick with this status gave a command to send. Real-time: yes.");
  m.def("names_wrong_sensor", &names_wrong_sensor, "status"_a,
        "Return whether a status names a sensor that has been wrong since the first sample.\n"
        "Real-time: yes.");
  nb::enum_<QpForm>(m, "QpForm",
                    "Form of the whole-body QP: how the equations of motion are eliminated.")
      .value("AUTO", QpForm::kAuto,
             "CONDENSED while this form is valid, else GENERAL, with\n"
             "hysteresis.")
      .value("CONDENSED", QpForm::kCondensed,
             "The variables are the contact forces. If a leg is nearly singular, the status is\n"
             "SINGULAR.")
      .value("GENERAL", QpForm::kGeneral,
             "The variables are the accelerations and contact forces. Valid for any pose and\n"
             "for further joints.");
  nb::enum_<BodyPoint>(m, "BodyPoint", "Point of the body that the position task moves.")
      .value("CENTER_OF_MASS", BodyPoint::kCenterOfMass, "The centre of mass of the robot.")
      .value("BASE", BodyPoint::kBase, "The origin of the base.");
}

// Vectors are returned as views. They can be set from anything that numpy converts to a vector of
// the right size; else the error names the field.
template <typename Struct, typename Vector>
auto get(Vector Struct::* member) {
  return [member](Struct& s) -> Vector& { return s.*member; };
}

template <typename Struct, typename Vector>
auto set(const char* name, Vector Struct::* member) {
  return [name, member](Struct& s, const nb::object& value) {
    constexpr int kSize = Vector::SizeAtCompileTime;
    const nb::object array = nb::module_::import_("numpy").attr("asarray")(value, "dtype"_a = "d");
    Eigen::VectorXd numbers;
    if (!nb::try_cast(array, numbers) || (kSize != Eigen::Dynamic && numbers.size() != kSize)) {
      const std::string size = kSize == Eigen::Dynamic ? "n" : std::to_string(kSize);
      const nb::str shape = nb::repr(nb::object(array.attr("shape")));
      const std::string text =
          std::string(name) + ": got shape " + shape.c_str() + ", expected (" + size + ",)";
      throw nb::value_error(text.c_str());
    }
    s.*member = numbers;
  };
}

Quaternion from_xyzw(const Eigen::Vector4d& q) {
  if (!(std::abs(q.norm() - 1.0) < 1e-6)) {
    throw Error("quaternion (x, y, z, w): got norm " + std::to_string(q.norm()) + ", expected 1");
  }
  return Quaternion(q[3], q[0], q[1], q[2]);
}

void bind_robot_state(nb::module_& m) {
  nb::class_<RobotState>(
      m, "RobotState",
      "State of the robot: pose, motion, contacts and external wrench.\n\n"
      "RobotState(nq, nv) is at rest, with the base level at the world origin. It\n"
      "raises Error unless nq >= 7 and nv >= 6. Arrays are writable numpy views; an\n"
      "assignment of another shape raises ValueError.")
      .def(nb::init<int, int>(), "nq"_a = 19, "nv"_a = 18)
      .def_prop_rw("q", get(&RobotState::q), set("q", &RobotState::q),
                   nb::for_getter(nb::rv_policy::reference_internal),
                   "Pinocchio's q: position [m], quaternion x y z w, joints [rad]; shape (nq,).")
      .def_prop_rw("v", get(&RobotState::v), set("v", &RobotState::v),
                   nb::for_getter(nb::rv_policy::reference_internal),
                   "Pinocchio's v: twist of the base in base axes, joint velocities; shape (nv,).")
      .def_prop_rw("contact", get(&RobotState::contact), set("contact", &RobotState::contact),
                   nb::for_getter(nb::rv_policy::reference_internal),
                   "Contact confidence of each foot, 0 .. 1, FR FL RR RL, shape (4,).\n\n"
                   "While the confidence of a stance foot is 0, the gains force_lost_contact and\n"
                   "share_lost_contact limit its load. To lift a foot, use FootReference.stance.")
      .def_prop_rw("f_external", get(&RobotState::f_external),
                   set("f_external", &RobotState::f_external),
                   nb::for_getter(nb::rv_policy::reference_internal),
                   "External force through the centre of mass [N], world axes, shape (3,): pushes\n"
                   "and payload.")
      .def_prop_rw("f_sustained", get(&RobotState::f_sustained),
                   set("f_sustained", &RobotState::f_sustained),
                   nb::for_getter(nb::rv_policy::reference_internal),
                   "Sustained part of f_external [N], world axes, shape (3,): a payload.\n\n"
                   "The holding torques include this force.")
      .def_prop_rw("moment_external", get(&RobotState::moment_external),
                   set("moment_external", &RobotState::moment_external),
                   nb::for_getter(nb::rv_policy::reference_internal),
                   "External moment about the centre of mass [N.m], world axes, shape (3,).\n\n"
                   "The estimator sets the sustained part only.")
      .def_prop_rw(
          "friction", get(&RobotState::friction), set("friction", &RobotState::friction),
          nb::for_getter(nb::rv_policy::reference_internal),
          "Share of RobotConfig.friction that each foot may use, 0 .. 1, shape (4,), FR FL\n"
          "RR RL.\n\n"
          "The share of a foot that slips is below 1.");
}

void bind_reference(nb::module_& m) {
  nb::class_<FootReference>(
      m, "FootReference",
      "Reference of one foot, in the world frame of RobotState. Arrays are writable\n"
      "views.")
      .def(nb::init<>())
      .def_rw("stance", &FootReference::stance,
              "True for a stance foot; False for a swing foot, which carries no force.")
      .def_rw("load", &FootReference::load,
              "Planned load, 0 .. 1. Ramp it up to make contact and down to break contact.")
      .def_prop_rw("p_world", get(&FootReference::p_world), set("p_world", &FootReference::p_world),
                   nb::for_getter(nb::rv_policy::reference_internal),
                   "Desired position of the contact point [m], shape (3,).")
      .def_prop_rw("v_world", get(&FootReference::v_world), set("v_world", &FootReference::v_world),
                   nb::for_getter(nb::rv_policy::reference_internal),
                   "Desired velocity of the contact point [m/s], shape (3,).")
      .def_prop_rw("a_world", get(&FootReference::a_world), set("a_world", &FootReference::a_world),
                   nb::for_getter(nb::rv_policy::reference_internal),
                   "Feed-forward acceleration of the contact point [m/s^2], shape (3,).")
      .def_prop_rw("f_world", get(&FootReference::f_world), set("f_world", &FootReference::f_world),
                   nb::for_getter(nb::rv_policy::reference_internal),
                   "Desired ground force on the foot [N], shape (3,); used if\n"
                   "Reference.use_forces is True.");
  nb::class_<Reference>(m, "Reference",
                        "Desired motion of the robot in the world frame of RobotState.\n\n"
                        "A planner writes a Reference in each tick. Arrays are writable numpy\n"
                        "views.")
      .def(nb::init<>())
      .def_rw("body_point", &Reference::body_point, "Point that the position task moves.")
      .def_prop_rw("p_com", get(&Reference::p_com), set("p_com", &Reference::p_com),
                   nb::for_getter(nb::rv_policy::reference_internal),
                   "Centre of mass [m], shape (3,); used if it is the body point.")
      .def_prop_rw("v_com", get(&Reference::v_com), set("v_com", &Reference::v_com),
                   nb::for_getter(nb::rv_policy::reference_internal),
                   "Velocity of the centre of mass [m/s], shape (3,).")
      .def_prop_rw("a_com", get(&Reference::a_com), set("a_com", &Reference::a_com),
                   nb::for_getter(nb::rv_policy::reference_internal),
                   "Feed-forward acceleration of the centre of mass [m/s^2], shape (3,).")
      .def_prop_rw("p_base", get(&Reference::p_base), set("p_base", &Reference::p_base),
                   nb::for_getter(nb::rv_policy::reference_internal),
                   "Origin of the base [m], shape (3,); used if it is the body point.")
      .def_prop_rw("v_base", get(&Reference::v_base), set("v_base", &Reference::v_base),
                   nb::for_getter(nb::rv_policy::reference_internal),
                   "Velocity of the base origin [m/s], world axes, shape (3,).")
      .def_prop_rw("a_base", get(&Reference::a_base), set("a_base", &Reference::a_base),
                   nb::for_getter(nb::rv_policy::reference_internal),
                   "Feed-forward acceleration of the base origin [m/s^2], world axes, shape (3,).")
      .def_prop_rw(
          "quat_world_base",
          [](const Reference& r) { return Eigen::Vector4d(r.R_world_base.coeffs()); },
          [](Reference& r, const Eigen::Vector4d& q) { r.R_world_base = from_xyzw(q); },
          "Orientation of the base, quaternion x y z w as in RobotState.q[3:7]; a copy.\n\n"
          "Raises Error unless it has unit length.")
      .def_prop_rw("w_world_base", get(&Reference::w_world_base),
                   set("w_world_base", &Reference::w_world_base),
                   nb::for_getter(nb::rv_policy::reference_internal),
                   "Angular velocity of the base [rad/s], world axes, shape (3,).")
      .def_prop_rw("alpha_world_base", get(&Reference::alpha_world_base),
                   set("alpha_world_base", &Reference::alpha_world_base),
                   nb::for_getter(nb::rv_policy::reference_internal),
                   "Feed-forward angular acceleration [rad/s^2], world axes, shape (3,).")
      .def_prop_rw(
          "L_com", get(&Reference::L_com), set("L_com", &Reference::L_com),
          nb::for_getter(nb::rv_policy::reference_internal),
          "Angular momentum about the centre of mass [kg.m^2/s], world axes, shape (3,).\n\n"
          "Used if gain weight_momentum is above 0.")
      .def_prop_rw("Ldot_com", get(&Reference::Ldot_com), set("Ldot_com", &Reference::Ldot_com),
                   nb::for_getter(nb::rv_policy::reference_internal),
                   "Feed-forward rate of L_com [N.m], world axes, shape (3,).")
      .def(
          "foot",
          [](Reference& r, int leg) -> FootReference& {
            if (leg < 0 || leg >= kLegs) throw nb::index_error("leg out of range, expected 0 .. 3");
            return r.feet[leg];
          },
          "leg"_a, nb::rv_policy::reference_internal,
          "Return the FootReference of a leg; changes to it change this object. leg: 0 FR,\n"
          "1 FL, 2 RR, 3 RL.\n\n"
          "Raises IndexError for another number.")
      .def_rw("use_forces", &Reference::use_forces,
              "True if the QP regularises the forces towards foot(i).f_world, not towards even\n"
              "forces.")
      .def_prop_rw("posture", get(&Reference::posture), set("posture", &Reference::posture),
                   nb::for_getter(nb::rv_policy::reference_internal),
                   "Joint angles of the posture task [rad], shape (nv - 6,), order of v[6:].\n\n"
                   "Empty: the standing pose.")
      .def_prop_rw("ground_normal", get(&Reference::ground_normal),
                   set("ground_normal", &Reference::ground_normal),
                   nb::for_getter(nb::rv_policy::reference_internal),
                   "Ground normal, the same for all feet: unit length, pointing out of the\n"
                   "ground, shape (3,).");
}

void bind_solution(nb::module_& m) {
  nb::class_<Solution>(m, "Solution",
                       "Solution of the whole-body QP.\n\n"
                       "For a status other than OK and SATURATED, all fields but iterations and\n"
                       "residuals are those of the last good tick.")
      .def_ro("status", &Solution::status, "Result of the tick.")
      .def_ro("form", &Solution::form, "Form of the QP that was solved: CONDENSED or GENERAL.")
      .def_ro("accelerations", &Solution::accelerations,
              "Generalised accelerations, shape (nv,), Pinocchio's order and base axes.")
      .def_ro("forces", &Solution::forces,
              "Ground force on each foot [N], world axes, shape (3, 4), FR FL RR RL.")
      .def_ro("torques", &Solution::torques,
              "Joint torques [N.m], shape (nv - 6,), order of v[6:].")
      .def_ro("clipped_torque", &Solution::clipped_torque,
              "Largest amount by which a torque was clipped at a motor limit [N.m].")
      .def_ro("torque_limit_violation", &Solution::torque_limit_violation,
              "Largest slack of the torque limits, as a share of tau_max.")
      .def_ro("joint_limit_violation", &Solution::joint_limit_violation,
              "Largest slack of the joint position and velocity limits, as a joint acceleration\n"
              "[rad/s^2].")
      .def_ro("hold_down_violation", &Solution::hold_down_violation,
              "Largest slack of the hold-down forces [N].")
      .def_ro("iterations", &Solution::iterations, "Number of inner iterations of the solver.")
      .def_ro("primal_residual", &Solution::primal_residual,
              "Primal residual of the scaled QP, computed by Surefoot and not taken from the\n"
              "solver library.")
      .def_ro("dual_residual", &Solution::dual_residual,
              "Dual residual of the scaled QP, computed by Surefoot and not taken from the\n"
              "solver library.");
}

}  // namespace

void bind_types(nb::module_& m) {
  bind_status(m);
  bind_robot_state(m);
  bind_reference(m);
  bind_solution(m);
}
