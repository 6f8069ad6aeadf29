// SPDX-License-Identifier: BSD-3-Clause
#include <boost/test/unit_test.hpp>
#include <utility>

#include "leaning.hpp"
#include "surefoot/whole_body_controller.hpp"
#include "wbc/own_limits.hpp"
#include "wbc/program_layout.hpp"

using namespace surefoot;

namespace {

// A robot pushed forward whose rear right calf runs towards its limit: what its foot's place asks
// of it is more than it may do. A limit met at a rate of 200 is far enough away to ask nothing.
struct Stretched : Leaning {
  JointTable joints = make_joint_table(robot);
  const int calf = 3 * RR_ + 2;
  double r = 30.0;

  Stretched() {
    state.q[joints[calf].q] = joints[calf].q_upper - 0.25;
    state.v[joints[calf].v] = 6.0;
  }

  // Where it is and as fast as it goes.
  void leave_foot() {
    reference.feet[RR_].p_world = dynamics.legs()[RR_].p_world_contact;
    reference.feet[RR_].v_world = dynamics.legs()[RR_].v_world_contact;
  }
  Solution solve(double speed, double contact, Form form = Form::kCondensed) {
    lean(Vector3(speed, 0.0, 0.0));
    leave_foot();
    state.contact[RR_] = contact;
    gains.joint_limit_rate = r;
    WholeBodyController controller(robot, gains, {form});
    return controller.update(state, reference);
  }
  double limit() const {
    const double room = joints[calf].q_upper - gains.joint_limit_margin - state.q[joints[calf].q];
    return r * r * room - 2.0 * r * state.v[joints[calf].v];
  }
  double asked(const Solution& s) const { return s.accelerations[joints[calf].v]; }
  // What the body was counted to feel beyond what forces and legs do to it [N], [N.m].
  Vector6 imagined(const Solution& s) {
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
  // Its calf may only go back, its thigh no slower than this; all its body may ask of it is let go.
  JointLimits rear_right_limits(double thigh) const {
    JointLimits limits(kMotors);
    limits.a_lower.setConstant(-1e3);
    limits.a_upper.setConstant(1e3);
    limits.a_lower[calf - 1] = thigh;
    limits.a_upper[calf] = -100.0;
    let_go(joints, 0.0, {1.0, 1.0, 0.0, 1.0}, reference, limits);
    return limits;
  }
  double body_turns(const Solution& a, const Solution& b) const {
    return (a.accelerations - b.accelerations).head<6>().norm();
  }
};

constexpr double kOverTheEdge = 2.0, kInside = 0.0;  // [m/s] forward

}  // namespace

BOOST_AUTO_TEST_SUITE(own_limits)

BOOST_FIXTURE_TEST_CASE(only_a_foot_that_bears_nothing_is_let_go_of_and_only_near_the_edge,
                        Stretched) {
  JointLimits limits(kMotors);
  joint_limits(robot.config(), joints, gains, Vector12::Ones(), state, limits);
  for (const double fade : {0.0, 0.4, 1.0}) {
    for (const double bears : {0.0, 0.7, 1.0}) {
      let_go(joints, fade, {1.0, 1.0, bears, 1.0}, reference, limits);
      for (int k = 0; k < kMotors; ++k) {
        const double more = k / 3 == RR_ ? 1e4 * (1.0 - fade) * (1.0 - bears) : 0.0;
        BOOST_TEST(std::abs(limits.more[k] - more) < 1e-9);
      }
    }
  }
}

// Believed on the ground or not: a foot that swings, or that was given up, is not to bear.
BOOST_FIXTURE_TEST_CASE(a_foot_that_is_not_meant_to_bear_is_let_go_of_as_well, Stretched) {
  JointLimits limits(kMotors);
  reference.feet[FL_].stance = false;
  reference.feet[RL_].load = 0.25;
  let_go(joints, 0.0, Eigen::Vector4d::Ones(), reference, limits);
  for (int k = 0; k < kMotors; ++k) {
    const double more = k / 3 == FL_ ? 1e4 : k / 3 == RL_ ? 7.5e3 : 0.0;
    BOOST_TEST(std::abs(limits.more[k] - more) < 1e-9);
  }
}

BOOST_FIXTURE_TEST_CASE(both_rows_of_such_a_leg_are_wider_by_that, Stretched) {
  const ProgramLayout layout(kMotors);
  const double more = 1e4 / ProgramUnits(robot).angular;
  state = standing_state(robot);  // its foot is asked what the leg can do
  lean(Vector3(kOverTheEdge, 0.0, 0.0));
  leave_foot();
  for (const Form form : {Form::kCondensed, Form::kGeneral}) {
    WholeBodyController controller(robot, gains, {form});
    controller.update(state, reference);
    const QpProblem held = controller.program();
    state.contact[RR_] = 0.0;
    controller.update(state, reference);
    const QpProblem& free = controller.program();
    for (int k = 0; k < kMotors; ++k) {
      const int row = layout.acceleration() + k;
      const double wider = k / 3 == RR_ ? more : 0.0;
      BOOST_TEST(std::abs(held.l[row] - free.l[row] - wider) < 1e-9);
      BOOST_TEST(std::abs(free.u[row] - held.u[row] - wider) < 1e-9);
    }
    state.contact[RR_] = 1.0;
  }
}

BOOST_FIXTURE_TEST_CASE(inside_a_stretched_leg_that_bears_nothing_holds_its_foot_and_the_body,
                        Stretched) {
  for (const Form form : {Form::kCondensed, Form::kGeneral}) {
    const Solution near = solve(kInside, 0.0, form);
    BOOST_TEST(asked(near) <= limit() + 1e-6);
    r = 200.0;
    const Solution free = solve(kInside, 0.0, form);
    r = 30.0;
    BOOST_TEST(asked(free) > limit() + 10.0);
    BOOST_TEST(body_turns(near, free) > 1.0);
  }
}

// Its foot called down by what the leg cannot do, the body must not count on that swing.
BOOST_FIXTURE_TEST_CASE(near_the_edge_the_body_counts_on_no_swing_that_its_leg_cannot_do,
                        Stretched) {
  for (const Form form : {Form::kCondensed, Form::kGeneral}) {
    reference.feet[RR_].a_world = Vector3(0.0, 0.0, -150.0);
    const Solution near = solve(kOverTheEdge, 0.0, form);
    BOOST_TEST(asked(near) <= limit() + 1e-6);
    BOOST_TEST(imagined(near).norm() < 0.05 * weight);
    r = 200.0;
    const Solution free = solve(kOverTheEdge, 0.0, form);
    r = 30.0;
    BOOST_TEST(asked(free) > limit() + 10.0);
    BOOST_TEST(imagined(free).norm() < 1e-6);
    BOOST_TEST(body_turns(near, free) > 1.0);
  }
}

BOOST_FIXTURE_TEST_CASE(a_leg_that_bears_keeps_its_foot_and_its_limit, Stretched) {
  const Solution near = solve(kOverTheEdge, 1.0);
  BOOST_TEST(asked(near) <= limit() + 1e-3);
  r = 200.0;
  BOOST_TEST(body_turns(near, solve(kOverTheEdge, 1.0)) > 1.0);
}

BOOST_FIXTURE_TEST_CASE(its_torques_are_those_of_its_own_motion, Stretched) {
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

// The conditions of Karush, Kuhn and Tucker: what is still missing pulls no joint that is free, and
// presses one that is held against its limit.
BOOST_FIXTURE_TEST_CASE(the_other_joints_of_such_a_leg_do_what_its_foot_was_asked_if_they_may,
                        Stretched) {
  lean(Vector3(kOverTheEdge, 0.0, 0.0));
  dynamics.update(state.q, state.v, Vector3::UnitZ());
  const Matrix3& J = dynamics.legs()[RR_].J_leg;
  const Vector3 asked(20.0, -240.0, 500.0);
  // As the calf gives way the thigh turns the other way: past a limit that it met at first, or, if
  // that is too far for it, on to there, and then the calf has room.
  for (const auto& [thigh, thigh_met] : {std::pair{-1e3, false}, {-100.0, false}, {600.0, true}}) {
    const JointLimits limits = rear_right_limits(thigh);
    Eigen::VectorXd a = Eigen::VectorXd::Zero(robot.nv()), tau = Eigen::VectorXd::Zero(kMotors);
    for (int j = 0; j < 3; ++j) a[joints[3 * RR_ + j].v] = asked[j];
    keep_own_limits(joints, dynamics, limits, a, tau);
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

BOOST_FIXTURE_TEST_CASE(the_feet_of_such_legs_alone_are_asked_what_their_joints_may_do, Stretched) {
  lean(Vector3(kOverTheEdge, 0.0, 0.0));
  dynamics.update(state.q, state.v, Vector3::UnitZ());
  JointLimits limits = rear_right_limits(-1e3);
  limits.a_upper[3 * FL_ + 2] = -100.0;  // one that bears has its limit too, and is not asked less
  const Vector3 asked(20.0, -240.0, 500.0);
  FeetMatrix feet;
  for (int leg = 0; leg < kLegs; ++leg) {
    const LegDynamics& L = dynamics.legs()[leg];
    feet.col(leg) = L.J_leg * asked + L.drift;
  }
  FeetMatrix within = feet;
  ask_within(dynamics, limits, 1.0, within);  // no leg turns as well as that
  BOOST_TEST((within - feet).isZero(0.0));
  ask_within(dynamics, limits, 1e-9, within);
  for (const int leg : {FR_, FL_, RL_}) BOOST_TEST((within - feet).col(leg).isZero(0.0));
  const LegDynamics& L = dynamics.legs()[RR_];
  const Vector3 kept = L.J_leg.inverse() * (within.col(RR_) - L.drift);
  BOOST_TEST(std::abs(kept[2] + 100.0) < 1e-6);
  const Vector3 pull = L.J_leg.transpose() * (feet - within).col(RR_);
  BOOST_TEST(pull.head<2>().norm() < 0.1);
  BOOST_TEST(pull[2] > 0.0);
}

BOOST_AUTO_TEST_SUITE_END()
