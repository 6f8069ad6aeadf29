// SPDX-License-Identifier: BSD-3-Clause
#include <nanobind/stl/string.h>

#include "bindings.hpp"
#include "surefoot/error.hpp"
#include "surefoot/types.hpp"
#include "value_class.hpp"

using namespace nb::literals;
using namespace surefoot;

namespace {

void bind_status(nb::module_& m) {
  nb::enum_<Status>(m, "Status",
                    "Result of a tick. A tick returns errors as a Status and never raises.")
      .value("OK", Status::kOk, "A command, or a solution, was computed.")
      .value("WAITING", Status::kWaiting, "No valid sample has arrived yet, or no tick has run.")
      .value("NON_FINITE", Status::kNonFinite,
             "A field that is read is NaN or infinite. In a LowState, also a magnitude above\n"
             "1e4.")
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
             "In the condensed form, a leg is nearly straight, or a foot near hip height.")
      .value("DAMPING", Status::kDamping, "Damping is latched; the motors damp until reset().")
      .value("BAD_TASK", Status::kBadTask,
             "A custom task failed, or wrote invalid rows or rows with too large weights.")
      .value("SATURATED", Status::kSaturated,
             "The command may be sent; a motor or the power is at its limit.")
      .value("DIVERGED", Status::kDiverged,
             "The state estimate diverged, because no motion explains the samples.")
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
             "CONDENSED while this form is valid, else GENERAL, with hysteresis.")
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

Quaternion from_xyzw(const Eigen::Vector4d& q) {
  if (!(std::abs(q.norm() - 1.0) < 1e-6)) {
    throw Error("quaternion (x, y, z, w): got norm " + std::to_string(q.norm()) + ", expected 1");
  }
  return Quaternion(q[3], q[0], q[1], q[2]);
}

void bind_robot_state(nb::module_& m) {
  ValueClass<RobotState>(m, "RobotState",
                         "State of the robot: pose, motion, contacts and external wrench.\n\n"
                         "Arrays are writable numpy views; an assignment of another shape raises\n"
                         "ValueError.")
      .def(nb::init<int, int>(), "nq"_a = 19, "nv"_a = 18,
           "Create a state at rest, with the base level at the world origin.\n\n"
           "Raises Error unless nq >= 7 and nv >= 6.")
      .def_rw("q", &RobotState::q,
              "Generalised position q of Pinocchio, shape (nq,).\n\n"
              "Position of the base in the world [m], quaternion x y z w from base to world\n"
              "axes, joint angles [rad].")
      .def_rw("v", &RobotState::v,
              "Generalised velocity v of Pinocchio, shape (nv,).\n\n"
              "Linear [m/s] and angular [rad/s] velocity of the base in base axes, joint\n"
              "velocities [rad/s].")
      .def_rw("contact", &RobotState::contact,
              "Contact confidence of each foot, 0 .. 1, FR FL RR RL, shape (4,).\n\n"
              "While the confidence of a stance foot is 0, the gains force_lost_contact and\n"
              "share_lost_contact limit its load; between 0 and 1 the limits are interpolated.\n"
              "To lift a foot, use FootReference.stance.")
      .def_rw("f_external", &RobotState::f_external,
              "External force through the centre of mass [N], world axes, shape (3,).\n\n"
              "Pushes and payload are included.")
      .def_rw("f_sustained", &RobotState::f_sustained,
              "Sustained part of f_external [N], world axes, shape (3,).\n\n"
              "A payload causes this force. The holding torques include it.")
      .def_rw("moment_external", &RobotState::moment_external,
              "External moment about the centre of mass [N.m], world axes, shape (3,).\n\n"
              "The estimator sets the sustained part only.")
      .def_rw("friction", &RobotState::friction,
              "Share of RobotConfig.friction that each foot may use, 0 .. 1, shape (4,), FR FL\n"
              "RR RL.\n\n"
              "It is below 1 on ground with less friction (EstimatorReport.friction), and smaller\n"
              "for a foot that slips.")
      .def_rw("armature_error", &RobotState::armature_error,
              "Rotor inertia of each joint as learnt by the estimator, minus RobotConfig.armature\n"
              "[kg.m^2], shape (12,), SDK motor order.\n\n"
              "The sum of both must not be negative.")
      .def_rw("joint_damping", &RobotState::joint_damping,
              "Viscous friction of each joint that the controllers compensate [N.m.s/rad], 0 or\n"
              "more, shape (12,), SDK motor order.\n\n"
              "The estimator sets it while the robot steps; a standing robot needs its damping.")
      .def_rw("joint_friction", &RobotState::joint_friction,
              "Coulomb friction of each joint that the controllers compensate [N.m], 0 or more,\n"
              "shape (12,), SDK motor order.\n\n"
              "The estimator sets it while the robot steps; a standing robot needs its damping.");
}

void bind_reference(nb::module_& m) {
  ValueClass<FootReference>(
      m, "FootReference",
      "Reference of one foot, in the world frame of RobotState. Arrays are writable\n"
      "numpy views.")
      .def(nb::init<>(), "Create a stance foot at the origin, at rest.")
      .def_rw("stance", &FootReference::stance,
              "True for a stance foot; False for a swing foot, planned without force.")
      .def_rw("load", &FootReference::load,
              "Planned load, 0 .. 1. Ramp it up to make contact and down to break contact.")
      .def_rw("min_contact", &FootReference::min_contact,
              "Smallest contact confidence that the force limits assume, 0 .. 1.\n\n"
              "A planner that knows when the foot lands sets it. 0: the limits follow\n"
              "RobotState.contact.")
      .def_rw("p_world", &FootReference::p_world,
              "Desired position of the contact point [m], shape (3,).")
      .def_rw("v_world", &FootReference::v_world,
              "Desired velocity of the contact point [m/s], shape (3,).")
      .def_rw("a_world", &FootReference::a_world,
              "Feed-forward acceleration of the contact point [m/s^2], shape (3,).")
      .def_rw("f_world", &FootReference::f_world,
              "Desired ground force on the foot [N], shape (3,); used if\n"
              "Reference.use_forces is True.");
  ValueClass<Reference>(m, "Reference",
                        "Desired motion of the robot in the world frame of RobotState.\n\n"
                        "A planner writes a Reference in each tick. Arrays are writable numpy\n"
                        "views.")
      .def(nb::init<>(), "Create a reference at rest at the world origin.")
      .def_rw("body_point", &Reference::body_point,
              "Point of the body that the position task moves.")
      .def_rw("p_com", &Reference::p_com,
              "Centre of mass [m], shape (3,); used if it is the body point.")
      .def_rw("v_com", &Reference::v_com, "Velocity of the centre of mass [m/s], shape (3,).")
      .def_rw("a_com", &Reference::a_com,
              "Feed-forward acceleration of the centre of mass [m/s^2], shape (3,).")
      .def_rw("p_base", &Reference::p_base,
              "Origin of the base [m], shape (3,); used if it is the body point.")
      .def_rw("v_base", &Reference::v_base,
              "Velocity of the base origin [m/s], world axes, shape (3,).")
      .def_rw("a_base", &Reference::a_base,
              "Feed-forward acceleration of the base origin [m/s^2], world axes, shape (3,).")
      .def_field<Eigen::Vector4d>(
          "quat_world_base",
          [](const Reference& r) { return Eigen::Vector4d(r.R_world_base.coeffs()); },
          [](Reference& r, FieldName field, nb::handle value) {
            r.R_world_base = from_xyzw(field_value<Eigen::Vector4d>(field, value));
          },
          "Orientation of the base, quaternion x y z w as in ``RobotState.q[3:7]``; a copy.\n\n"
          "Assignment raises Error unless the quaternion has unit length.")
      .def_rw(
          "stepping", &Reference::stepping,
          "True: feet are about to step, so the capture point may leave the support polygon.\n\n"
          "The QP then has no priorities at support edges, and the tilt weight, joint limit rate\n"
          "and hold-down of a walking robot. The tick predicts the state over the delay.")
      .def_rw("w_world_base", &Reference::w_world_base,
              "Angular velocity of the base [rad/s], world axes, shape (3,).")
      .def_rw("alpha_world_base", &Reference::alpha_world_base,
              "Feed-forward angular acceleration of the base [rad/s^2], world axes, shape (3,).")
      .def_rw("L_com", &Reference::L_com,
              "Angular momentum about the centre of mass [kg.m^2/s], world axes, shape (3,).\n\n"
              "Used if gain weight_momentum is above 0.")
      .def_rw("Ldot_com", &Reference::Ldot_com,
              "Feed-forward rate of L_com [N.m], world axes, shape (3,).")
      .def(
          "foot",
          [](Reference& r, int leg) -> FootReference& {
            if (leg < 0 || leg >= kLegs) throw nb::index_error("leg out of range, expected 0 .. 3");
            return r.feet[leg];
          },
          "leg"_a, nb::rv_policy::reference_internal,
          "Return the FootReference of a leg; changes to it change this object.\n\n"
          "The legs are 0 FR, 1 FL, 2 RR, 3 RL. Raises IndexError for another number.")
      .def_part(
          "feet",
          [](nb::handle self) {
            nb::list feet;
            for (int leg = 0; leg < kLegs; ++leg) feet.append(self.attr("foot")(leg));
            return feet;
          },
          [](nb::handle self, nb::handle feet) {
            for (int leg = 0; leg < kLegs; ++leg) {
              nb::cast<Reference&>(self).feet[leg] = nb::cast<FootReference>(feet[leg]);
            }
          })
      .def_rw("use_forces", &Reference::use_forces,
              "True if the QP regularises the forces towards foot(i).f_world, False if towards\n"
              "the even forces.")
      .def_rw("posture", &Reference::posture,
              "Joint angles of the posture task [rad], shape (nv - 6,), order of ``v[6:]``.\n\n"
              "An empty array selects the standing pose.")
      .def_rw("ground_normal", &Reference::ground_normal,
              "Ground normal, the same for all feet, shape (3,); unit length, pointing out of\n"
              "the ground.");
}

void bind_solution(nb::module_& m) {
  ValueClass<Solution>(m, "Solution",
                       "Solution of the whole-body QP.\n\n"
                       "If the status is neither OK nor SATURATED, all fields other than status,\n"
                       "iterations and residuals keep the values of the last good tick.")
      .def_ro("status", &Solution::status, "Result of the tick.")
      .def_ro("form", &Solution::form, "Form of the QP that was solved, CONDENSED or GENERAL.")
      .def_ro("accelerations", &Solution::accelerations,
              "Generalised accelerations, shape (nv,), Pinocchio's order.\n\n"
              "The acceleration of the base is spatial, in base axes.")
      .def_ro("forces", &Solution::forces,
              "Ground force on each foot [N], world axes, shape (3, 4), FR FL RR RL.")
      .def_ro("torques", &Solution::torques,
              "Joint torques [N.m], shape (nv - 6,), order of ``v[6:]``.")
      .def_ro("clipped_torque", &Solution::clipped_torque,
              "Largest amount clipped from a torque at a motor limit [N.m].")
      .def_ro("torque_limit_violation", &Solution::torque_limit_violation,
              "Largest slack of the torque limits, as a share of tau_max.")
      .def_ro("joint_limit_violation", &Solution::joint_limit_violation,
              "Largest slack of the joint position and velocity limits, as a joint acceleration\n"
              "[rad/s^2].")
      .def_ro("hold_down_violation", &Solution::hold_down_violation,
              "Largest slack of the hold-down forces [N].")
      .def_ro("iterations", &Solution::iterations,
              "Number of changes of the active set plus iterations of ProxQP.")
      .def_ro("primal_residual", &Solution::primal_residual,
              "Largest violation of a constraint of the scaled QP, computed by Surefoot and not\n"
              "taken from the solver library.")
      .def_ro("dual_residual", &Solution::dual_residual,
              "Largest entry of the gradient of the scaled QP's Lagrangian, computed by\n"
              "Surefoot and not taken from the solver library.");
}

}  // namespace

void bind_types(nb::module_& m) {
  bind_status(m);
  bind_robot_state(m);
  bind_reference(m);
  bind_solution(m);
}
