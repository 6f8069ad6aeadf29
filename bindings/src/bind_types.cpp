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
      .value("SATURATED", Status::kSaturated,
             "Good to send; a motor, or the power, is at its limit.")
      .value("DIVERGED", Status::kDiverged, "The state estimate ran away.");
  m.def("is_usable", &is_usable, "status"_a, "Does this status come with a command to send?");
  nb::enum_<QpForm>(m, "QpForm", "How the program eliminates the equations of motion.")
      .value("AUTO", QpForm::kAuto, "Condensed where it holds, general elsewhere.")
      .value("CONDENSED", QpForm::kCondensed, "Contact forces alone.")
      .value("GENERAL", QpForm::kGeneral, "Accelerations and contact forces.");
  nb::enum_<BodyPoint>(m, "BodyPoint", "Which point of the body the position task moves.")
      .value("CENTER_OF_MASS", BodyPoint::kCenterOfMass, "The centre of mass.")
      .value("BASE", BodyPoint::kBase, "The origin of the base.");
}

// Vectors: handed out as views; taken from anything that numpy makes one of, or refused by name.
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
  nb::class_<RobotState>(m, "RobotState",
                         "Where the robot is and how it moves.\n\n"
                         "q and v are Pinocchio's; contact is the belief per foot, 0 .. 1.")
      .def(nb::init<int, int>(), "nq"_a = 19, "nv"_a = 18)
      .def_prop_rw("q", get(&RobotState::q), set("q", &RobotState::q),
                   nb::for_getter(nb::rv_policy::reference_internal),
                   "Position, quaternion x y z w, joints; shape (nq,).")
      .def_prop_rw("v", get(&RobotState::v), set("v", &RobotState::v),
                   nb::for_getter(nb::rv_policy::reference_internal),
                   "Base twist in base axes, joint velocities; shape (nv,).")
      .def_prop_rw("contact", get(&RobotState::contact), set("contact", &RobotState::contact),
                   nb::for_getter(nb::rv_policy::reference_internal),
                   "Belief 0 .. 1 that the foot stands, FR FL RR RL: gains force_lost_contact and "
                   "share_lost_contact say what is left of its load at 0. To lift a foot see "
                   "FootReference.stance.")
      .def_prop_rw("f_external", get(&RobotState::f_external),
                   set("f_external", &RobotState::f_external),
                   nb::for_getter(nb::rv_policy::reference_internal),
                   "Force from outside through the CoM [N], world.")
      .def_prop_rw("f_sustained", get(&RobotState::f_sustained),
                   set("f_sustained", &RobotState::f_sustained),
                   nb::for_getter(nb::rv_policy::reference_internal),
                   "The part of f_external that lasts, a payload [N].")
      .def_prop_rw("moment_external", get(&RobotState::moment_external),
                   set("moment_external", &RobotState::moment_external),
                   nb::for_getter(nb::rv_policy::reference_internal),
                   "Moment from outside about the CoM [N.m], world.")
      .def_prop_rw("friction", get(&RobotState::friction), set("friction", &RobotState::friction),
                   nb::for_getter(nb::rv_policy::reference_internal),
                   "What is left of each foot's friction coefficient, 0 .. 1, FR FL RR RL.");
}

void bind_reference(nb::module_& m) {
  nb::class_<FootReference>(m, "FootReference", "What one foot is asked to do, world frame.")
      .def(nb::init<>())
      .def_rw("stance", &FootReference::stance, "False: swing, carries no force.")
      .def_rw("load", &FootReference::load, "Planned share 0 .. 1; ramp it to open or close.")
      .def_prop_rw("p_world", get(&FootReference::p_world), set("p_world", &FootReference::p_world),
                   nb::for_getter(nb::rv_policy::reference_internal),
                   "Where its contact point belongs [m].")
      .def_prop_rw("v_world", get(&FootReference::v_world), set("v_world", &FootReference::v_world),
                   nb::for_getter(nb::rv_policy::reference_internal), "[m/s].")
      .def_prop_rw("a_world", get(&FootReference::a_world), set("a_world", &FootReference::a_world),
                   nb::for_getter(nb::rv_policy::reference_internal), "[m/s^2].")
      .def_prop_rw("f_world", get(&FootReference::f_world), set("f_world", &FootReference::f_world),
                   nb::for_getter(nb::rv_policy::reference_internal),
                   "Ground on foot [N]; see use_forces.");
  nb::class_<Reference>(m, "Reference", "What the robot is asked to do, world frame of RobotState.")
      .def(nb::init<>())
      .def_rw("body_point", &Reference::body_point, "Which point the position task moves.")
      .def_prop_rw("p_com", get(&Reference::p_com), set("p_com", &Reference::p_com),
                   nb::for_getter(nb::rv_policy::reference_internal), "Centre of mass [m].")
      .def_prop_rw("v_com", get(&Reference::v_com), set("v_com", &Reference::v_com),
                   nb::for_getter(nb::rv_policy::reference_internal), "[m/s].")
      .def_prop_rw("a_com", get(&Reference::a_com), set("a_com", &Reference::a_com),
                   nb::for_getter(nb::rv_policy::reference_internal), "Feed-forward [m/s^2].")
      .def_prop_rw("p_base", get(&Reference::p_base), set("p_base", &Reference::p_base),
                   nb::for_getter(nb::rv_policy::reference_internal), "Origin of the base [m].")
      .def_prop_rw("v_base", get(&Reference::v_base), set("v_base", &Reference::v_base),
                   nb::for_getter(nb::rv_policy::reference_internal), "[m/s], world axes.")
      .def_prop_rw("a_base", get(&Reference::a_base), set("a_base", &Reference::a_base),
                   nb::for_getter(nb::rv_policy::reference_internal),
                   "Feed-forward [m/s^2], world axes.")
      .def_prop_rw(
          "quat_world_base",
          [](const Reference& r) { return Eigen::Vector4d(r.R_world_base.coeffs()); },
          [](Reference& r, const Eigen::Vector4d& q) { r.R_world_base = from_xyzw(q); },
          "Orientation of the base, quaternion x y z w as in RobotState.q[3:7].")
      .def_prop_rw("w_world_base", get(&Reference::w_world_base),
                   set("w_world_base", &Reference::w_world_base),
                   nb::for_getter(nb::rv_policy::reference_internal), "[rad/s], world axes.")
      .def_prop_rw("alpha_world_base", get(&Reference::alpha_world_base),
                   set("alpha_world_base", &Reference::alpha_world_base),
                   nb::for_getter(nb::rv_policy::reference_internal), "Feed-forward [rad/s^2].")
      .def_prop_rw("L_com", get(&Reference::L_com), set("L_com", &Reference::L_com),
                   nb::for_getter(nb::rv_policy::reference_internal),
                   "Angular momentum [kg.m^2/s], world axes.")
      .def_prop_rw("Ldot_com", get(&Reference::Ldot_com), set("Ldot_com", &Reference::Ldot_com),
                   nb::for_getter(nb::rv_policy::reference_internal), "Feed-forward [N.m].")
      .def(
          "foot",
          [](Reference& r, int leg) -> FootReference& {
            if (leg < 0 || leg >= kLegs) throw nb::index_error("leg out of range: 0 .. 3");
            return r.feet[leg];
          },
          "leg"_a, nb::rv_policy::reference_internal, "Reference of a foot: FR FL RR RL = 0 .. 3.")
      .def_rw("use_forces", &Reference::use_forces, "Draw forces to foot(i).f_world, not to even.")
      .def_prop_rw("posture", get(&Reference::posture), set("posture", &Reference::posture),
                   nb::for_getter(nb::rv_policy::reference_internal),
                   "Joints [rad], (nv - 6,), or empty: standing pose.")
      .def_prop_rw("ground_normal", get(&Reference::ground_normal),
                   set("ground_normal", &Reference::ground_normal),
                   nb::for_getter(nb::rv_policy::reference_internal), "Unit, out of the ground.");
}

void bind_solution(nb::module_& m) {
  nb::class_<Solution>(m, "Solution", "What the whole-body program decided.")
      .def_ro("status", &Solution::status, "OK or SATURATED; else the rest is that of before.")
      .def_ro("form", &Solution::form, "Which form was solved.")
      .def_ro("accelerations", &Solution::accelerations, "Shape (nv,), Pinocchio's order.")
      .def_ro("forces", &Solution::forces, "Ground on foot [N], world, (3, 4), FR FL RR RL.")
      .def_ro("torques", &Solution::torques, "[N.m] shape (nv - 6,), order of v[6:].")
      .def_ro("clipped_torque", &Solution::clipped_torque, "Most the final clip took [N.m].")
      .def_ro("torque_limit_violation", &Solution::torque_limit_violation,
              "Most torque limits gave, of tau_max.")
      .def_ro("joint_limit_violation", &Solution::joint_limit_violation, "Same, joints [rad/s^2].")
      .def_ro("hold_down_violation", &Solution::hold_down_violation, "Same, feet held down [N].")
      .def_ro("iterations", &Solution::iterations, "Inner iterations of the solver.")
      .def_ro("primal_residual", &Solution::primal_residual, "Our own check.")
      .def_ro("dual_residual", &Solution::dual_residual, "Our own check.");
}

}  // namespace

void bind_types(nb::module_& m) {
  bind_status(m);
  bind_robot_state(m);
  bind_reference(m);
  bind_solution(m);
}
