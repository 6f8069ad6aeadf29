// SPDX-License-Identifier: BSD-3-Clause
#include <boost/test/unit_test.hpp>
#include <utility>

#include "capture_point_robot.hpp"
#include "surefoot/whole_body_controller.hpp"
#include "wbc/qp_layout.hpp"
#include "wbc/qp_units.hpp"
#include "wbc/released_legs.hpp"

using namespace surefoot;

namespace {

// A robot pushed forward whose rear right calf runs towards its limit: the desired foot
// acceleration needs more than the calf may do. With joint_limit_rate = 200 the limit does not act.
struct StretchedLeg : CapturePointRobot {
  JointTable joints = make_joint_table(robot);
  const int calf = 3 * RR_ + 2;
  double r = 30.0;

  StretchedLeg() {
    state.q[joints[calf].q] = joints[calf].q_upper - 0.25;
    state.v[joints[calf].v] = 6.0;
  }

  // Set the foot reference to the present position and velocity of the foot.
  void set_foot_target_to_its_motion() {
    reference.feet[RR_].p_world = dynamics.legs()[RR_].p_world_contact;
    reference.feet[RR_].v_world = dynamics.legs()[RR_].v_world_contact;
  }
  Solution solve(double speed, double contact, QpForm form = QpForm::kCondensed) {
    set_com_velocity(Vector3(speed, 0.0, 0.0));
    set_foot_target_to_its_motion();
    state.contact[RR_] = contact;
    gains.joint_limit_rate = r;
    WholeBodyController controller(robot, gains, {form});
    return controller.update(state, reference);
  }
  double limit() const {
    const double room = joints[calf].q_upper - gains.joint_limit_margin - state.q[joints[calf].q];
    return r * r * room - 2.0 * r * state.v[joints[calf].v];
  }
  double calf_acceleration(const Solution& s) const { return s.accelerations[joints[calf].v]; }
  // Return the wrench on the base that neither foot forces nor leg motion explain [N], [N.m].
  Vector6 base_wrench_residual(const Solution& s) {
    dynamics.update(state.q, state.v, Vector3::UnitZ());
    Vector6 a_base = s.accelerations.head<6>();
    a_base.head<3>() -= dynamics.a_base_shift();
    Vector6 wrench = dynamics.M_base() * a_base + dynamics.h_base();
    for (int leg = 0; leg < kLegs; ++leg) {
      const LegDynamics& L = dynamics.legs()[leg];
      for (int j = 0; j < 3; ++j) {
        wrench += L.M_base_leg.col(j) * s.accelerations[joints[3 * leg + j].v];
      }
      wrench -= L.J_base.transpose() * s.forces.col(leg);
    }
    return wrench;
  }
  // The calf must move back at 100 rad/s^2, the thigh has a lower limit, and the leg is fully
  // released.
  JointLimits rear_right_limits(double thigh) const {
    JointLimits limits(kMotors);
    limits.a_lower.setConstant(-1e3);
    limits.a_upper.setConstant(1e3);
    limits.a_lower[calf - 1] = thigh;
    limits.a_upper[calf] = -100.0;
    release_unloaded_legs(joints, 0.0, {1.0, 1.0, 0.0, 1.0}, reference, limits);
    return limits;
  }
  double base_acceleration_change(const Solution& a, const Solution& b) const {
    return (a.accelerations - b.accelerations).head<6>().norm();
  }
};

constexpr double kOverTheEdge = 2.0, kInside = 0.0;  // [m/s] forward

}  // namespace

BOOST_AUTO_TEST_SUITE(released_legs)

BOOST_FIXTURE_TEST_CASE(unloaded_feet_are_released_near_the_edge_and_while_stepping, StretchedLeg) {
  JointLimits limits(kMotors);
  joint_limits(robot.config(), joints, gains, false, Vector12::Ones(), state, limits);
  for (const double fade : {0.0, 0.4, 1.0, -1.0}) {
    reference.stepping = fade < 0.0;
    const double share = reference.stepping ? 1.0 : 1.0 - fade;
    for (const double bears : {0.0, 0.7, 1.0}) {
      release_unloaded_legs(joints, std::abs(fade), {1.0, 1.0, bears, 1.0}, reference, limits);
      for (int k = 0; k < kMotors; ++k) {
        const double more = k / 3 == RR_ ? 1e4 * share * (1.0 - bears) : 0.0;
        BOOST_TEST(std::abs(limits.a_widening[k] - more) < 1e-9);
      }
    }
  }
}

// Swing feet and feet with little planned load are released, whatever their contact confidence.
BOOST_FIXTURE_TEST_CASE(swing_and_lightly_loaded_feet_are_released_too, StretchedLeg) {
  JointLimits limits(kMotors);
  reference.feet[FL_].stance = false;
  reference.feet[RL_].load = 0.25;
  release_unloaded_legs(joints, 0.0, Eigen::Vector4d::Ones(), reference, limits);
  for (int k = 0; k < kMotors; ++k) {
    const double more = k / 3 == FL_ ? 1e4 : k / 3 == RL_ ? 7.5e3 : 0.0;
    BOOST_TEST(std::abs(limits.a_widening[k] - more) < 1e-9);
  }
}

// A swing foot must reach further than its joints can move. If its joint limits held for the whole
// robot, as for a swing foot of a robot that does not step, the QP would throw the body.
BOOST_FIXTURE_TEST_CASE(swing_foot_out_of_reach_does_not_throw_the_body, StretchedLeg) {
  for (const int leg : {FL_, RR_}) reference.feet[leg].stance = false;
  gains.walk_joint_limit_rate = gains.joint_limit_rate = r;
  const auto base_acceleration = [&](bool stepping) {
    reference.stepping = stepping;
    set_foot_target_to_its_motion();
    reference.feet[RR_].a_world = Vector3(300.0, 0.0, 0.0);
    WholeBodyController controller(robot, gains, {QpForm::kCondensed});
    const Solution solution = controller.update(state, reference);
    BOOST_TEST(calf_acceleration(solution) <= limit() + 1e-3);
    return solution.accelerations.head<6>().norm();
  };
  BOOST_TEST(base_acceleration(true) < 0.3 * base_acceleration(false));
}

BOOST_FIXTURE_TEST_CASE(released_leg_has_wider_upper_and_lower_joint_bounds, StretchedLeg) {
  const QpLayout layout(kMotors);
  const double more = 1e4 / QpUnits(robot).angular;
  state = standing_state(robot);  // the leg can produce its foot's acceleration
  set_com_velocity(Vector3(kOverTheEdge, 0.0, 0.0));
  set_foot_target_to_its_motion();
  for (const QpForm form : {QpForm::kCondensed, QpForm::kGeneral}) {
    WholeBodyController controller(robot, gains, {form});
    controller.update(state, reference);
    const QpProblem held = controller.qp();
    state.contact[RR_] = 0.0;
    controller.update(state, reference);
    const QpProblem& free = controller.qp();
    for (int k = 0; k < kMotors; ++k) {
      const int row = layout.acceleration() + k;
      const double wider = k / 3 == RR_ ? more : 0.0;
      BOOST_TEST(std::abs(held.l[row] - free.l[row] - wider) < 1e-9);
      BOOST_TEST(std::abs(free.u[row] - held.u[row] - wider) < 1e-9);
    }
    state.contact[RR_] = 1.0;
  }
}

BOOST_FIXTURE_TEST_CASE(unloaded_stretched_leg_is_not_released_inside_the_support, StretchedLeg) {
  for (const QpForm form : {QpForm::kCondensed, QpForm::kGeneral}) {
    const Solution near = solve(kInside, 0.0, form);
    BOOST_TEST(calf_acceleration(near) <= limit() + 1e-6);
    r = 200.0;
    const Solution free = solve(kInside, 0.0, form);
    r = 30.0;
    BOOST_TEST(calf_acceleration(free) > limit() + 10.0);
    BOOST_TEST(base_acceleration_change(near, free) > 1.0);
  }
}

// The reference requests a foot acceleration that the leg cannot produce. The body must not count
// on the reaction of that motion.
BOOST_FIXTURE_TEST_CASE(body_near_the_edge_uses_no_impossible_leg_motion, StretchedLeg) {
  for (const QpForm form : {QpForm::kCondensed, QpForm::kGeneral}) {
    reference.feet[RR_].a_world = Vector3(0.0, 0.0, -150.0);
    const Solution near = solve(kOverTheEdge, 0.0, form);
    BOOST_TEST(calf_acceleration(near) <= limit() + 1e-6);
    BOOST_TEST(base_wrench_residual(near).norm() < 0.05 * weight);
    r = 200.0;
    const Solution free = solve(kOverTheEdge, 0.0, form);
    r = 30.0;
    BOOST_TEST(calf_acceleration(free) > limit() + 10.0);
    BOOST_TEST(base_wrench_residual(free).norm() < 1e-6);
    BOOST_TEST(base_acceleration_change(near, free) > 1.0);
  }
}

BOOST_FIXTURE_TEST_CASE(loaded_leg_is_not_released, StretchedLeg) {
  const Solution near = solve(kOverTheEdge, 1.0);
  BOOST_TEST(calf_acceleration(near) <= limit() + 1e-3);
  r = 200.0;
  BOOST_TEST(base_acceleration_change(near, solve(kOverTheEdge, 1.0)) > 1.0);
}

BOOST_FIXTURE_TEST_CASE(released_leg_torques_match_its_motion, StretchedLeg) {
  const Solution s = solve(kOverTheEdge, 0.0);
  Dynamics dynamics(robot);
  dynamics.update(state.q, state.v, Vector3::UnitZ());
  const LegDynamics& leg = dynamics.legs()[RR_];
  Vector6 a_base = s.accelerations.head<6>();
  a_base.head<3>() -= dynamics.a_base_shift();
  Vector3 a, tau;
  for (int j = 0; j < 3; ++j) {
    a[j] = s.accelerations[joints[3 * RR_ + j].v];
    tau[j] = s.torques[joints[3 * RR_ + j].v - 6];
  }
  const Vector3 expected = leg.M_base_leg.transpose() * a_base + leg.M_leg * a + leg.h_leg -
                           leg.J_leg.transpose() * s.forces.col(RR_);
  BOOST_TEST((tau - expected).norm() < 1e-9);
}

// Karush-Kuhn-Tucker conditions: the remaining error has no gradient along a free joint, and pushes
// a limited joint against its limit.
BOOST_FIXTURE_TEST_CASE(other_joints_of_a_released_leg_still_track_the_foot_target, StretchedLeg) {
  set_com_velocity(Vector3(kOverTheEdge, 0.0, 0.0));
  dynamics.update(state.q, state.v, Vector3::UnitZ());
  const Matrix3& J = dynamics.legs()[RR_].J_leg;
  const Vector3 asked(20.0, -240.0, 500.0);
  // As the calf is limited, the thigh turns the other way. It may pass a limit that it met at
  // first. If its limit is further away, it stops there, and the calf is free.
  for (const auto& [thigh, thigh_met] : {std::pair{-1e3, false}, {-100.0, false}, {600.0, true}}) {
    const JointLimits limits = rear_right_limits(thigh);
    Eigen::VectorXd a = Eigen::VectorXd::Zero(robot.nv()), tau = Eigen::VectorXd::Zero(kMotors);
    for (int j = 0; j < 3; ++j) a[joints[3 * RR_ + j].v] = asked[j];
    clamp_released_legs(joints, dynamics, limits, a, tau);
    Vector3 kept;
    for (int j = 0; j < 3; ++j) kept[j] = a[joints[3 * RR_ + j].v];
    const Vector3 pull = J.transpose() * (J * (asked - kept));
    BOOST_TEST(std::abs(pull[0]) < 0.05);
    BOOST_TEST((kept[1] == thigh) == thigh_met);
    BOOST_TEST((thigh_met ? pull[1] < 0.0 : std::abs(pull[1]) < 0.05));
    BOOST_TEST(kept[1] >= thigh);
    BOOST_TEST((kept[2] == -100.0) == !thigh_met);
    BOOST_TEST((thigh_met ? std::abs(pull[2]) < 0.05 : pull[2] > 0.0));
    const Vector3 change = dynamics.legs()[RR_].M_leg * (kept - asked);
    BOOST_TEST((tau.segment<3>(3 * RR_) - change).norm() < 1e-9);
    tau.segment<3>(3 * RR_).setZero();
    BOOST_TEST(tau.isZero(0.0));
  }
}

BOOST_FIXTURE_TEST_CASE(only_released_feet_get_feasible_acceleration_targets, StretchedLeg) {
  set_com_velocity(Vector3(kOverTheEdge, 0.0, 0.0));
  dynamics.update(state.q, state.v, Vector3::UnitZ());
  JointLimits limits = rear_right_limits(-1e3);
  limits.a_upper[3 * FL_ + 2] = -100.0;  // a loaded leg with a limit keeps its target
  const Vector3 asked(20.0, -240.0, 500.0);
  FeetMatrix feet;
  for (int leg = 0; leg < kLegs; ++leg) {
    const LegDynamics& L = dynamics.legs()[leg];
    feet.col(leg) = L.J_leg * asked + L.drift;
  }
  FeetMatrix within = feet;
  limit_foot_accelerations(dynamics, limits, 1.0, within);  // all legs count as singular
  BOOST_TEST((within - feet).isZero(0.0));
  limit_foot_accelerations(dynamics, limits, 1e-9, within);
  for (const int leg : {FR_, FL_, RL_}) BOOST_TEST((within - feet).col(leg).isZero(0.0));
  const LegDynamics& L = dynamics.legs()[RR_];
  const Vector3 kept = L.J_leg.inverse() * (within.col(RR_) - L.drift);
  BOOST_TEST(std::abs(kept[2] + 100.0) < 1e-6);
  const Vector3 pull = L.J_leg.transpose() * (feet - within).col(RR_);
  BOOST_TEST(pull.head<2>().norm() < 0.1);
  BOOST_TEST(pull[2] > 0.0);
}

BOOST_AUTO_TEST_SUITE_END()
