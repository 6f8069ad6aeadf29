// SPDX-License-Identifier: BSD-3-Clause
#include <nanobind/eigen/dense.h>
#include <nanobind/stl/string.h>

#include "bindings.hpp"
#include "surefoot/error.hpp"
#include "surefoot/stand_controller.hpp"
#include "surefoot/state_estimator.hpp"
#include "surefoot/whole_body_controller.hpp"

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
      .value("DAMPING", Status::kDamping, "Latched: the motors brake until reset().");
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
      .def_rw("contact", &RobotState::contact, "Probability of load per foot, FR FL RR RL.");
  nb::class_<FootReference>(m, "FootReference", "What one foot is asked to do, world frame.")
      .def(nb::init<>())
      .def_rw("stance", &FootReference::stance, "False: swing, carries no force.")
      .def_rw("p_world", &FootReference::p_world, "Where its contact point belongs [m].")
      .def_rw("v_world", &FootReference::v_world, "[m/s].")
      .def_rw("a_world", &FootReference::a_world, "[m/s^2].");
  nb::class_<Reference>(m, "Reference", "What the robot is asked to do, world frame of RobotState.")
      .def(nb::init<>())
      .def_rw("p_com", &Reference::p_com, "Centre of mass [m].")
      .def_rw("v_com", &Reference::v_com, "[m/s].")
      .def_rw("a_com", &Reference::a_com, "Feed-forward [m/s^2].")
      .def_prop_rw(
          "quat_world_base", [](const Reference& r) { return to_wxyz(r.R_world_base); },
          [](Reference& r, const Eigen::Vector4d& q) { r.R_world_base = from_wxyz(q); },
          "Orientation of the base, quaternion w x y z.")
      .def_rw("w_world_base", &Reference::w_world_base, "[rad/s], world axes.")
      .def_rw("alpha_world_base", &Reference::alpha_world_base, "Feed-forward [rad/s^2].")
      .def(
          "foot",
          [](Reference& r, int leg) -> FootReference& {
            if (leg < 0 || leg >= kLegs) throw nb::index_error("leg out of range: 0 .. 3");
            return r.feet[leg];
          },
          "leg"_a, nb::rv_policy::reference_internal, "Reference of a foot: FR FL RR RL = 0 .. 3.")
      .def_rw("ground_normal", &Reference::ground_normal, "Unit, out of the ground.");
  nb::class_<Solution>(m, "Solution", "What the whole-body program decided.")
      .def_ro("status", &Solution::status, "OK, or why the rest is that of the last good tick.")
      .def_ro("accelerations", &Solution::accelerations, "Shape (nv,), Pinocchio's order.")
      .def_ro("forces", &Solution::forces, "Ground on foot [N], world, (3, 4), FR FL RR RL.")
      .def_ro("torques", &Solution::torques, "[N.m] shape (nv - 6,), order of v[6:].")
      .def_ro("iterations", &Solution::iterations, "Inner iterations of the solver.")
      .def_ro("primal_residual", &Solution::primal_residual, "Our own check.")
      .def_ro("dual_residual", &Solution::dual_residual, "Our own check.");
}

void bind_whole_body(nb::module_& m) {
  nb::class_<WholeBodyController>(m, "WholeBodyController",
                                  "State and reference in, joint torques out.\n\n"
                                  "For people who bring their own estimator or planner.")
      .def(nb::init<const Robot&>(), "robot"_a)
      .def(nb::init<const Robot&, const Gains&>(), "robot"_a, "gains"_a)
      .def(
          "update",
          [](WholeBodyController& c, const RobotState& s, const Reference& r) {
            return Solution(c.update(s, r));
          },
          "state"_a, "reference"_a, "Compute one tick: Solution. Never raises.")
      .def("hold", &WholeBodyController::hold, "state"_a,
           "Make the reference that asks the robot to stay as it is; raises Error on a wrong size.")
      .def("set_gains", &WholeBodyController::set_gains, "gains"_a,
           "Raise Error if one is invalid.")
      .def_prop_ro(
          "gains", [](const WholeBodyController& c) { return Gains(c.gains()); }, "A copy.")
      .def("reset", &WholeBodyController::reset, "Forget the warm start.");
}

void bind_estimator(nb::module_& m) {
  nb::class_<StateEstimator>(m, "StateEstimator", "LowState in, RobotState out.")
      .def(nb::init<const Robot&>(), "robot"_a)
      .def("update", &StateEstimator::update, "low_state"_a, "dt"_a,
           "Take in one report, dt seconds after the last: Status. Never raises.")
      .def_prop_ro(
          "state", [](const StateEstimator& e) { return RobotState(e.state()); }, "A copy.")
      .def_prop_ro("torque_force", &StateEstimator::torque_force, "Normal force per foot [N].")
      .def_prop_ro("foot_force_alive", &StateEstimator::foot_force_alive, "Does footForceEst live?")
      .def("set_gains", &StateEstimator::set_gains, "gains"_a, "Raise Error if one is invalid.")
      .def("reset", &StateEstimator::reset, "Begin anew with the next report.");
}

void bind_stand(nb::module_& m) {
  nb::class_<StandOptions>(m, "StandOptions", "What is set once, as opposed to tuned.")
      .def(nb::init<>())
      .def(
          "__init__", [](StandOptions* o, double d) { new (o) StandOptions{d}; }, "motor_damping"_a)
      .def_rw("motor_damping", &StandOptions::motor_damping,
              "[N.m.s/rad] motor-side damping in every command; 0 is pure torque mode.");
  nb::class_<StandController>(
      m, "StandController",
      "Holds the body where and as it stands: LowState in, LowCmd out.\n\n"
      "Torque mode: Kp = Kd = 0, q = PosStopF, dq = VelStopF. On a bad report "
      "or solve the last\ngood command is repeated for at most 10 ms, then the "
      "motors damp until reset().")
      .def(nb::init<const Robot&>(), "robot"_a)
      .def(nb::init<const Robot&, const Gains&, const StandOptions&>(), "robot"_a, "gains"_a,
           "options"_a = StandOptions())
      .def(
          "update", [](StandController& c, const LowState& s) { return LowCmd(c.update(s)); },
          "low_state"_a, "Compute one tick: LowCmd. Never raises; read status.")
      .def_prop_ro("status", &StandController::status, "What this tick's command is worth.")
      .def_prop_ro("fault", &StandController::fault, "What was wrong when a tick last was not OK.")
      .def_prop_ro(
          "state", [](const StandController& c) { return RobotState(c.state()); },
          "Estimate, a copy.")
      .def_prop_ro(
          "reference", [](const StandController& c) { return Reference(c.reference()); }, "A copy.")
      .def_prop_ro(
          "solution", [](const StandController& c) { return Solution(c.solution()); }, "A copy.")
      .def_prop_ro("torque_force", &StandController::torque_force,
                   "Normal force per foot from torques [N].")
      .def_prop_ro("foot_force_alive", &StandController::foot_force_alive,
                   "Does footForceEst live?")
      .def_prop_ro(
          "gains", [](const StandController& c) { return Gains(c.gains()); }, "A copy.")
      .def("set_gains", &StandController::set_gains, "gains"_a, "Raise Error if one is invalid.")
      .def("reset", &StandController::reset, "Leave damping; latch the pose anew.");
}

}  // namespace

void bind_control(nb::module_& m) {
  bind_status(m);
  bind_structs(m);
  bind_whole_body(m);
  bind_estimator(m);
  bind_stand(m);
}
