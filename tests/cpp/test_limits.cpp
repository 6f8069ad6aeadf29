// SPDX-License-Identifier: BSD-3-Clause
#include <boost/test/unit_test.hpp>

#include "random_reference.hpp"
#include "surefoot/whole_body_controller.hpp"
#include "tasks/foot_loads.hpp"
#include "wbc/hold_down.hpp"
#include "wbc/joint_limits.hpp"

using namespace surefoot;

namespace {

struct LimitsFixture {
  Robot robot = quadruped();
  JointTable joints = make_joint_table(robot);
  Gains gains;
  JointLimits limits{kMotors};
  RobotState state = standing_state(robot);
  void update(bool stepping = false) {
    joint_limits(robot.config(), joints, gains, stepping, Vector12::Ones(), state, limits);
  }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(limits_)

BOOST_FIXTURE_TEST_CASE(lower_limits_never_exceed_upper_limits_in_any_state, LimitsFixture) {
  RandomReference random(1);
  for (int k = 0; k < 20000; ++k) {
    const double size = std::pow(10.0, random.number(6.0));
    gains.joint_limit_rate = 100.0 + random.number(99.0);
    for (int i = 0; i < kMotors; ++i) {
      state.q[7 + i] = random.number(size);
      state.v[6 + i] = random.number(size);
    }
    update();
    BOOST_REQUIRE((limits.a_lower.array() <= limits.a_upper.array()).all());
    BOOST_REQUIRE((limits.tau_lower.array() <= 0.0).all());
    BOOST_REQUIRE((limits.tau_upper.array() >= 0.0).all());
    BOOST_REQUIRE(limits.a_lower.allFinite() && limits.a_upper.allFinite());
  }
}

BOOST_FIXTURE_TEST_CASE(torque_limit_falls_with_speed_only_while_the_motor_drives, LimitsFixture) {
  const RobotConfig& c = robot.config();
  for (const double dq : {-20.0, -5.0, 0.0, 5.0, 20.0}) {
    state.v.tail(kMotors).setConstant(dq);
    update();
    const double share = (c.no_load_speed[0] - 20.0) / (c.no_load_speed[0] - c.corner_speed[0]);
    const double weak = share * c.tau_max[0];
    BOOST_TEST(std::abs(limits.tau_upper[3] - (dq > 12.0 ? weak : c.tau_max[0])) < 1e-12);
    BOOST_TEST(std::abs(limits.tau_lower[3] + (dq < -12.0 ? weak : c.tau_max[0])) < 1e-12);
  }
}

BOOST_AUTO_TEST_CASE(hip_inward_limits_only_hip_joints_and_only_inward) {
  RobotConfig config = quadruped_config();
  config.hip_inward = 0.3;
  const JointTable joints = make_joint_table(quadruped(config));
  for (int i = 0; i < kMotors; ++i) {
    const bool hip = i % 3 == 0, left = i / 3 % 2 == 1;
    BOOST_TEST(joints[i].q_lower == (hip && left ? -0.3 : config.q_lower[i]));
    BOOST_TEST(joints[i].q_upper == (hip && !left ? 0.3 : config.q_upper[i]));
  }
}

// With the largest allowed accelerations a joint reaches full speed, and still stops in time.
BOOST_FIXTURE_TEST_CASE(joint_at_maximum_acceleration_stops_before_its_limit, LimitsFixture) {
  const double dt = 0.002;
  for (const double direction : {1.0, -1.0}) {
    state = standing_state(robot);
    double max_joint_speed = 0.0;
    for (int k = 0; k < 1500; ++k) {
      update();
      for (int row = 0; row < kMotors; ++row) {
        state.v[joints[row].v] += dt * (direction > 0.0 ? limits.a_upper : limits.a_lower)[row];
        state.q[joints[row].q] += dt * state.v[joints[row].v];
        const double q = state.q[joints[row].q];
        BOOST_REQUIRE(q <= joints[row].q_upper - gains.joint_limit_margin + 1e-9);
        BOOST_REQUIRE(q >= joints[row].q_lower + gains.joint_limit_margin - 1e-9);
      }
      max_joint_speed = std::max(max_joint_speed, state.v.tail(kMotors).cwiseAbs().maxCoeff());
    }
    BOOST_TEST(max_joint_speed <= robot.config().dq_max[0] + 1e-9);
    BOOST_TEST(max_joint_speed > 8.0);
    for (const JointRow& joint : joints) {
      const double end = direction > 0.0 ? joint.q_upper - gains.joint_limit_margin
                                         : joint.q_lower + gains.joint_limit_margin;
      BOOST_TEST(std::abs(state.q[joint.q] - end) < 1e-6);
    }
  }
}

BOOST_FIXTURE_TEST_CASE(joint_beyond_its_position_or_speed_limit_is_driven_back, LimitsFixture) {
  state.q[joints[2].q] = joints[2].q_upper + 0.1;
  state.v[joints[5].v] = joints[5].dq_max + 5.0;
  update();
  BOOST_TEST(limits.a_upper[2] < -50.0);
  BOOST_TEST(limits.a_upper[5] < -50.0);
}

// The whole controller on an ideal robot: the body is requested too low, and the knees stop in
// time.
BOOST_FIXTURE_TEST_CASE(stepping_robot_has_its_own_joint_limit_rate, LimitsFixture) {
  state.v[6] = 1.0;
  update(true);
  const JointLimits stepping = limits;
  gains.joint_limit_rate = gains.walk_joint_limit_rate;
  update();
  BOOST_TEST((stepping.a_upper == limits.a_upper && stepping.a_lower == limits.a_lower));
  gains = Gains();
  update();
  BOOST_TEST(stepping.a_upper[0] > 2.0 * limits.a_upper[0]);
}

BOOST_AUTO_TEST_CASE(body_requested_too_low_keeps_joints_inside_their_limits) {
  const Robot robot = tight_limit_quadruped(30.0, 0.35);
  const RobotConfig& c = robot.config();
  for (const QpForm form : {QpForm::kCondensed, QpForm::kGeneral}) {
    WholeBodyController controller(robot, Gains(), {form});
    RobotState state = standing_state(robot);
    Reference reference = controller.hold(state);
    reference.p_com.z() -= 0.15;
    const double dt = 0.002;
    double room = 1e9;
    for (int k = 0; k < 1500; ++k) {
      const Solution& s = controller.update(state, reference);
      BOOST_REQUIRE(is_usable(s.status));
      state.q = integrate(robot, state.q, dt * state.v + 0.5 * dt * dt * s.accelerations);
      state.v += dt * s.accelerations;
      for (int i = 0; i < kMotors; ++i) {
        const double q = state.q[robot.motor_to_q()[i]];
        room = std::min({room, q - c.q_lower[i], c.q_upper[i] - q});
      }
    }
    BOOST_TEST(room > 0.5 * Gains().joint_limit_margin);
    BOOST_TEST(room < 2.0 * Gains().joint_limit_margin);
    BOOST_TEST(state.v.norm() < 1e-2);
  }
}

BOOST_AUTO_TEST_CASE(foot_force_limit_follows_contact_confidence_and_load) {
  const Gains g;
  Reference reference;
  reference.feet[RR_].stance = false;
  reference.feet[RL_].load = 0.5;
  const Eigen::Vector4d contact(1.0, 0.0, 1.0, 0.4);
  const Eigen::Vector4d most = normal_force_limits(g, 100.0, contact, reference);
  const double middle = g.force_lost_contact + 0.4 * (g.force_max_contact - g.force_lost_contact);
  BOOST_TEST(
      (most - 100.0 * Eigen::Vector4d(g.force_max_contact, g.force_lost_contact, 0.0, 0.5 * middle))
          .norm() < 1e-9);
  const Eigen::Vector4d shares = load_shares(g, contact, reference);
  BOOST_TEST(shares[FR_] == 1.0);
  BOOST_TEST(shares[FL_] == g.share_lost_contact);
  BOOST_TEST(shares[RR_] == 0.0);
}

// A planner that knows when a foot lands need not wait for its contact confidence.
BOOST_AUTO_TEST_CASE(min_contact_raises_the_force_limits_of_a_planned_foot) {
  const Gains g;
  Reference reference;
  const Eigen::Vector4d contact(0.0, 0.5, 0.9, 0.0);
  for (FootReference& foot : reference.feet) foot.min_contact = 0.6;
  reference.feet[RL_].stance = false;
  const Eigen::Vector4d assumed(0.6, 0.6, 0.9, 0.0);
  const Eigen::Vector4d limits = normal_force_limits(g, 100.0, contact, reference);
  const Eigen::Vector4d shares = load_shares(g, contact, reference);
  const Eigen::Vector4d hold_down = hold_down_forces(g, 100.0, 1.0, contact, reference);
  for (FootReference& foot : reference.feet) foot.min_contact = 0.0;
  BOOST_TEST((limits - normal_force_limits(g, 100.0, assumed, reference)).norm() == 0.0);
  BOOST_TEST((shares - load_shares(g, assumed, reference)).norm() == 0.0);
  BOOST_TEST((hold_down - hold_down_forces(g, 100.0, 1.0, assumed, reference)).norm() == 0.0);
  BOOST_TEST(limits[FR_] > 2.0 * normal_force_limits(g, 100.0, contact, reference)[FR_]);
  BOOST_TEST(limits[RL_] == 0.0);
}

BOOST_AUTO_TEST_SUITE_END()
