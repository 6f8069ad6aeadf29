// SPDX-License-Identifier: BSD-3-Clause
#include <boost/test/unit_test.hpp>

#include "robot_states.hpp"
#include "tick/delay_predictor.hpp"

using namespace surefoot;

namespace {

constexpr double kDelay = 0.012, kDt = 0.002;

struct DelayPredictorFixture {
  Robot robot = quadruped();
  RobotState state = standing_state(robot);
  Eigen::VectorXd a = Eigen::VectorXd::LinSpaced(18, -3.0, 5.0);
  DelayPredictor predictor{18, kDelay};
  void send(const Eigen::VectorXd& acceleration, double dt) {
    predictor.record(acceleration, acceleration.tail<12>(), acceleration.head<3>());
    predictor.advance(dt);
  }
  DelayPredictorFixture() { state.contact << 0.1, 0.2, 0.3, 0.4; }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(delay_predictor)

BOOST_FIXTURE_TEST_CASE(acting_command_is_the_one_sent_one_delay_ago, DelayPredictorFixture) {
  BOOST_TEST((predictor.acting_command(kDt) == nullptr));
  for (int k = 0; k < 6; ++k) send(k * a, kDt);
  BOOST_TEST((predictor.acting_command(kDt) == nullptr));  // six of 2 ms are all pending
  for (int k = 6; k < 30; ++k) {
    send(k * a, kDt);
    BOOST_REQUIRE((predictor.acting_command(kDt)->accelerations - (k - 6) * a).norm() < 1e-12);
  }
  BOOST_TEST((predictor.acting_command(kDt)->tau - 23.0 * a.tail<12>()).norm() < 1e-12);
  BOOST_TEST((predictor.acting_command(kDt)->f_push - 23.0 * a.head<3>()).norm() < 1e-12);
  predictor.advance(kDt);  // a sample was lost: the last command keeps acting
  BOOST_TEST((predictor.acting_command(kDt)->accelerations - 24.0 * a).norm() < 1e-12);
}

// The link needs one period for the sample and one for the command.
BOOST_FIXTURE_TEST_CASE(zero_delay_option_assumes_a_link_delay_of_two_periods,
                        DelayPredictorFixture) {
  DelayPredictor undelayed(18, 0.0);
  for (int k = 0; k < 5; ++k) {
    BOOST_REQUIRE((undelayed.acting_command(kDt) == nullptr) == (k < 3));
    if (k >= 3)
      BOOST_TEST((undelayed.acting_command(kDt)->accelerations - (k - 3) * a).norm() < 1e-12);
    undelayed.record(k * a, Vector12::Zero(), Vector3::Zero());
    undelayed.advance(kDt);
  }
  undelayed.advance(kDt);  // a sample was lost
  BOOST_TEST((undelayed.acting_command(kDt)->accelerations - 3.0 * a).norm() < 1e-12);
  undelayed.advance(3.0 * kDt);  // the last command was held
  BOOST_TEST((undelayed.acting_command(kDt)->accelerations - 4.0 * a).norm() < 1e-12);
}

BOOST_FIXTURE_TEST_CASE(constant_acceleration_of_joints_and_base_is_predicted_exactly,
                        DelayPredictorFixture) {
  a.segment<3>(3).setZero();  // rotation has its own test
  state.v = Eigen::VectorXd::LinSpaced(18, 1.0, -1.0);
  state.v.segment<3>(3).setZero();
  for (int k = 0; k < 10; ++k) send(a, kDt);
  const RobotState& predicted = predictor.predict(state, kDt);
  const Eigen::VectorXd step = kDelay * state.v + 0.5 * kDelay * kDelay * a;
  BOOST_TEST((predicted.v - state.v - kDelay * a).norm() < 1e-12);
  BOOST_TEST((predicted.q.tail(12) - state.q.tail(12) - step.tail(12)).norm() < 1e-12);
  BOOST_TEST((predicted.q.head<3>() - state.q.head<3>() - step.head<3>()).norm() < 1e-12);
  BOOST_TEST((predicted.contact - state.contact).norm() == 0.0);
}

BOOST_FIXTURE_TEST_CASE(constant_base_rotation_is_predicted, DelayPredictorFixture) {
  const Quaternion tilted = exp_so3(Vector3(0.3, -0.2, 1.0));
  const Vector3 w(1.0, -2.0, 0.5);
  state.q.segment<4>(3) = tilted.coeffs();
  state.v.segment<3>(3) = w;
  const RobotState& predicted = predictor.predict(state, kDt);
  const Quaternion R(predicted.q[6], predicted.q[3], predicted.q[4], predicted.q[5]);
  BOOST_TEST(R.angularDistance(tilted * exp_so3(kDelay * w)) < 1e-7);
  BOOST_TEST(std::abs(R.norm() - 1.0) < 1e-12);
}

// The expected state integrates the same accelerations, command by command.
BOOST_FIXTURE_TEST_CASE(pending_commands_act_in_the_order_they_were_sent, DelayPredictorFixture) {
  Eigen::VectorXd v = state.v, q = state.q.tail(12);
  for (int k = 0; k < 9; ++k) {
    const Eigen::VectorXd sent = (k - 2.0) * a;
    send(sent, kDt);
    if (k < 3) continue;  // acts before the measurement: six of 2 ms fill the delay
    q += kDt * v.tail(12) + 0.5 * kDt * kDt * sent.tail(12);
    v += kDt * sent;
  }
  const RobotState& predicted = predictor.predict(state, kDt);
  BOOST_TEST((predicted.v - v).norm() < 1e-12);
  BOOST_TEST((predicted.q.tail(12) - q).norm() < 1e-12);
}

BOOST_FIXTURE_TEST_CASE(command_held_longer_than_the_delay_counts_for_its_part,
                        DelayPredictorFixture) {
  send(100.0 * a, 0.010);
  send(a, 0.008);  // acts for the last 8 of 12 ms; the command before it acts for the first 4 ms
  const RobotState& predicted = predictor.predict(state, kDt);
  BOOST_TEST((predicted.v - state.v - (0.004 * 100.0 + 0.008) * a).norm() < 1e-12);
}

BOOST_FIXTURE_TEST_CASE(command_buffer_wraps_and_drops_the_oldest_commands, DelayPredictorFixture) {
  DelayPredictor fresh(18, kDelay);
  for (int k = 0; k < 200; ++k) send((k % 7) * a, kDt);
  for (int k = 190; k < 200; ++k) {
    fresh.record((k % 7) * a, Vector12::Zero(), Vector3::Zero());
    fresh.advance(kDt);
  }
  BOOST_TEST((predictor.predict(state, kDt).v - fresh.predict(state, kDt).v).norm() == 0.0);
  BOOST_TEST((predictor.predict(state, kDt).q - fresh.predict(state, kDt).q).norm() == 0.0);
}

BOOST_FIXTURE_TEST_CASE(reset_clears_pending_commands, DelayPredictorFixture) {
  for (int k = 0; k < 10; ++k) send(a, kDt);
  predictor.reset();
  BOOST_TEST((predictor.predict(state, kDt).v - state.v).norm() == 0.0);
}

BOOST_FIXTURE_TEST_CASE(horizon_is_the_delay_or_without_one_two_periods, DelayPredictorFixture) {
  BOOST_TEST(predictor.horizon(kDt) == kDelay);
  BOOST_TEST(predictor.horizon(2.0 * kDt) == kDelay);
  DelayPredictor undelayed(18, 0.0);
  BOOST_TEST(undelayed.horizon(kDt) == 2.0 * kDt);
  state.v.setOnes();
  for (int k = 0; k < 5; ++k) {
    undelayed.record(a, Vector12::Zero(), Vector3::Zero());
    undelayed.advance(kDt);
  }
  const RobotState& predicted = undelayed.predict(state, kDt);
  BOOST_TEST((predicted.v - state.v - 2.0 * kDt * a).norm() < 1e-12);
  const Eigen::VectorXd step = 2.0 * kDt * (state.v + kDt * a);
  BOOST_TEST((predicted.q.tail(12) - state.q.tail(12) - step.tail(12)).norm() < 1e-12);
}

// Far from standing, the prediction agrees with Pinocchio's integration to second order.
BOOST_FIXTURE_TEST_CASE(random_motion_is_predicted_to_second_order_in_the_delay,
                        DelayPredictorFixture) {
  for (int seed = 0; seed < 20; ++seed) {
    const RobotState random = random_state(robot, seed, 1.0);
    for (int k = 0; k < 10; ++k) send(a, kDt);
    Eigen::VectorXd q = random.q, v = random.v;
    const int steps = 1000;
    for (int k = 0; k < steps; ++k) {
      const double h = kDelay / steps;
      q = integrate(robot, q, h * v + 0.5 * h * h * a);
      v += h * a;
    }
    const RobotState& predicted = predictor.predict(random, kDt);
    BOOST_TEST((predicted.v - v).norm() < 1e-9);
    BOOST_TEST((predicted.q - q).norm() < 4.0 * kDelay * kDelay);
  }
}

BOOST_AUTO_TEST_SUITE_END()
