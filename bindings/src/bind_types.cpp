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
  nb::enum_<Status>(m, "Status", "What became of a tick.")
      .value("OK", Status::kOk, "Fresh command.")
      .value("WAITING", Status::kWaiting, "No valid state has come yet.")
      .value("NON_FINITE", Status::kNonFinite, "A used field is NaN, infinite or absurd.")
      .value("IMPLAUSIBLE", Status::kImplausible, "A used field is beyond what the robot can say.")
      .value("FALLEN", Status::kFallen, "The base is tilted beyond the gain fall_tilt.")
      .value("BAD_REFERENCE", Status::kBadReference, "No unit quaternion or upward unit normal.")
      .value("WRONG_SIZE", Status::kWrongSize, "q or v is not of the robot's size.")
      .value("BAD_QUATERNION", Status::kBadQuaternion, "Zero, or far from unit length.")
      .value("STALE_TICK", Status::kStaleTick, "tick did not advance.")
      .value("MAX_ITERATIONS", Status::kMaxIterations, "The solver hit its cap.")
      .value("INFEASIBLE", Status::kInfeasible, "The solver called the program infeasible.")
      .value("SINGULAR", Status::kSingular, "A leg is straight or its foot near hip height.")
      .value("DAMPING", Status::kDamping, "Latched: the motors brake until reset().")
      .value("BAD_TASK", Status::kBadTask, "A task of yours failed or wrote no number.")
      .value("SATURATED", Status::kSaturated, "Good to send; less than the motion needs.");
  m.def("is_usable", &is_usable, "status"_a, "Does this status come with a command to send?");
  nb::enum_<Form>(m, "Form", "How the program eliminates the equations of motion.")
      .value("AUTO", Form::kAuto, "Condensed where it holds, general elsewhere.")
      .value("CONDENSED", Form::kCondensed, "Contact forces alone.")
      .value("GENERAL", Form::kGeneral, "Accelerations and contact forces.");
  nb::enum_<BodyPoint>(m, "BodyPoint", "Which point of the body the position task moves.")
      .value("CENTER_OF_MASS", BodyPoint::kCenterOfMass, "The centre of mass.")
      .value("BASE", BodyPoint::kBase, "The origin of the base.");
}

// Eigen quaternion <-> numpy (w, x, y, z).
Eigen::Vector4d to_wxyz(const Quaternion& q) { return {q.w(), q.x(), q.y(), q.z()}; }
Quaternion from_wxyz(const Eigen::Vector4d& q) {
  if (!(std::abs(q.norm() - 1.0) < 1e-6)) {
    throw Error("quaternion (w, x, y, z): got norm " + std::to_string(q.norm()) + ", expected 1");
  }
  return Quaternion(q[0], q[1], q[2], q[3]);
}

void bind_structs(nb::module_& m) {
  nb::class_<RobotState>(m, "RobotState",
                         "Where the robot is and how it moves.\n\n"
                         "q and v are Pinocchio's; contact is the belief per foot, 0 .. 1.")
      .def(nb::init<int, int>(), "nq"_a = 19, "nv"_a = 18)
      .def_rw("q", &RobotState::q, "Position, quaternion x y z w, joints; shape (nq,).")
      .def_rw("v", &RobotState::v, "Base twist in base axes, joint velocities; shape (nv,).")
      .def_rw("contact", &RobotState::contact, "Probability of load per foot, FR FL RR RL.")
      .def_rw("f_outside", &RobotState::f_outside,
              "Force from outside through the CoM [N], world.");
}

void bind_reference(nb::module_& m) {
  nb::class_<FootReference>(m, "FootReference", "What one foot is asked to do, world frame.")
      .def(nb::init<>())
      .def_rw("stance", &FootReference::stance, "False: swing, carries no force.")
      .def_rw("load", &FootReference::load, "Planned share 0 .. 1; ramp it to open or close.")
      .def_rw("p_world", &FootReference::p_world, "Where its contact point belongs [m].")
      .def_rw("v_world", &FootReference::v_world, "[m/s].")
      .def_rw("a_world", &FootReference::a_world, "[m/s^2].")
      .def_rw("f_world", &FootReference::f_world, "Ground on foot [N]; see use_forces.");
  nb::class_<Reference>(m, "Reference", "What the robot is asked to do, world frame of RobotState.")
      .def(nb::init<>())
      .def_rw("body_point", &Reference::body_point, "Which point the position task moves.")
      .def_rw("p_com", &Reference::p_com, "Centre of mass [m].")
      .def_rw("v_com", &Reference::v_com, "[m/s].")
      .def_rw("a_com", &Reference::a_com, "Feed-forward [m/s^2].")
      .def_rw("p_base", &Reference::p_base, "Origin of the base [m].")
      .def_rw("v_base", &Reference::v_base, "[m/s], world axes.")
      .def_rw("a_base", &Reference::a_base, "Feed-forward [m/s^2], world axes.")
      .def_prop_rw(
          "quat_world_base", [](const Reference& r) { return to_wxyz(r.R_world_base); },
          [](Reference& r, const Eigen::Vector4d& q) { r.R_world_base = from_wxyz(q); },
          "Orientation of the base, quaternion w x y z.")
      .def_rw("w_world_base", &Reference::w_world_base, "[rad/s], world axes.")
      .def_rw("alpha_world_base", &Reference::alpha_world_base, "Feed-forward [rad/s^2].")
      .def_rw("L_com", &Reference::L_com, "Angular momentum [kg.m^2/s], world axes.")
      .def_rw("Ldot_com", &Reference::Ldot_com, "Feed-forward [N.m].")
      .def(
          "foot",
          [](Reference& r, int leg) -> FootReference& {
            if (leg < 0 || leg >= kLegs) throw nb::index_error("leg out of range: 0 .. 3");
            return r.feet[leg];
          },
          "leg"_a, nb::rv_policy::reference_internal, "Reference of a foot: FR FL RR RL = 0 .. 3.")
      .def_rw("use_forces", &Reference::use_forces, "Draw forces to foot(i).f_world, not to even.")
      .def_rw("posture", &Reference::posture, "Joints [rad], (nv - 6,), or empty: standing pose.")
      .def_rw("ground_normal", &Reference::ground_normal, "Unit, out of the ground.");
}

void bind_solution(nb::module_& m) {
  nb::class_<Solution>(m, "Solution", "What the whole-body program decided.")
      .def_ro("status", &Solution::status, "OK or SATURATED; else the rest is that of before.")
      .def_ro("form", &Solution::form, "Which form was solved.")
      .def_ro("accelerations", &Solution::accelerations, "Shape (nv,), Pinocchio's order.")
      .def_ro("forces", &Solution::forces, "Ground on foot [N], world, (3, 4), FR FL RR RL.")
      .def_ro("torques", &Solution::torques, "[N.m] shape (nv - 6,), order of v[6:].")
      .def_ro("torque_residual", &Solution::torque_residual, "Most the final clip took [N.m].")
      .def_ro("torque_excess", &Solution::torque_excess, "Most torque limits gave, of tau_max.")
      .def_ro("joint_limit_excess", &Solution::joint_limit_excess, "Same, joints [rad/s^2].")
      .def_ro("hold_down_missing", &Solution::hold_down_missing, "Same, feet held down [N].")
      .def_ro("iterations", &Solution::iterations, "Inner iterations of the solver.")
      .def_ro("primal_residual", &Solution::primal_residual, "Our own check.")
      .def_ro("dual_residual", &Solution::dual_residual, "Our own check.");
}

}  // namespace

void bind_types(nb::module_& m) {
  bind_status(m);
  bind_structs(m);
  bind_reference(m);
  bind_solution(m);
}
