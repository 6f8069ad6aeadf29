// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/QR>
#include <boost/test/unit_test.hpp>

#include "estimator/external_wrench/payload_observer.hpp"
#include "estimator/external_wrench/push_observer.hpp"
#include "robot_states.hpp"
#include "surefoot/state_estimator.hpp"

using namespace surefoot;

namespace {

constexpr double kPeriod = 0.002;

struct PayloadFixture {
  Robot robot = quadruped();
  RobotState state = standing_state(robot);
  Dynamics dynamics{robot};
  Gains gains;
  PayloadObserver payload{robot.mass()};
  double weight = robot.mass() * kGravity;

  PayloadFixture() { dynamics.update(state.q, state.v, Vector3::UnitZ()); }

  void set_velocity(const Vector3& velocity) {
    state.v.head<3>() = velocity;  // the standing robot is level and faces x
    dynamics.update(state.q, state.v, Vector3::UnitZ());
  }
  // Return the minimum-norm foot forces that balance gravity and an external wrench about the
  // centre of mass.
  FeetMatrix balancing_forces(const Vector3& force, const Vector3& moment) const {
    Eigen::Matrix<double, 6, 12> A;
    for (int leg = 0; leg < kLegs; ++leg) {
      A.block<3, 3>(0, 3 * leg).setIdentity();
      A.block<3, 3>(3, 3 * leg) =
          skew(dynamics.legs()[leg].p_world_contact - dynamics.p_world_com());
    }
    Vector6 b;
    b << weight * Vector3::UnitZ() - force, -moment;
    const Vector12 f = A.completeOrthogonalDecomposition().solve(b);
    return Eigen::Map<const FeetMatrix>(f.data());
  }
  void run(double seconds, const FeetMatrix& forces, bool supported = true, bool stepping = false) {
    for (int k = 0; k < seconds / kPeriod - 0.5; ++k) {
      payload.update(gains, dynamics, forces, supported, stepping, kPeriod);
    }
  }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(external_wrench)

BOOST_FIXTURE_TEST_CASE(unloaded_robot_has_zero_payload, PayloadFixture) {
  run(5.0, balancing_forces(Vector3::Zero(), Vector3::Zero()));
  BOOST_TEST(payload.force().norm() < 1e-9);
  BOOST_TEST(payload.moment().norm() < 1e-9);
  BOOST_TEST(payload.com_shift().norm() < 1e-9);
}

BOOST_FIXTURE_TEST_CASE(external_wrench_is_estimated_from_foot_forces_over_payload_time,
                        PayloadFixture) {
  const Vector3 force(5.0, -3.0, -20.0), moment(1.0, -2.0, 0.5);
  run(1.0, balancing_forces(Vector3::Zero(), Vector3::Zero()));
  run(gains.payload_time, balancing_forces(force, moment));
  const double risen = 1.0 - std::exp(-1.0);
  BOOST_TEST((payload.force() - risen * force).norm() < 0.01 * force.norm());
  BOOST_TEST((payload.moment() - risen * moment).norm() < 0.01 * moment.norm());
  run(20.0 * gains.payload_time, balancing_forces(force, moment));
  BOOST_TEST((payload.force() - force).norm() < 1e-6);
  BOOST_TEST((payload.moment() - moment).norm() < 1e-6);
}

// A push makes the robot step. The payload from before the push stays, the push does not.
BOOST_FIXTURE_TEST_CASE(wrench_of_a_push_is_not_kept_while_feet_step, PayloadFixture) {
  const Vector3 payload_force(0.0, 0.0, -20.0), push(0.0, 50.0, 0.0);
  run(10.0, balancing_forces(payload_force, Vector3::Zero()));
  set_velocity(Vector3(0.0, 0.3, 0.0));
  run(0.1, balancing_forces(payload_force + push, Vector3::Zero()));
  BOOST_TEST(payload.force().y() > 0.4 * push.y());
  run(1.0, balancing_forces(payload_force, Vector3::Zero()), true, true);
  BOOST_TEST((payload.force() - payload_force).norm() < 1e-3);
}

BOOST_FIXTURE_TEST_CASE(moment_of_a_payload_turns_with_a_stepping_robot, PayloadFixture) {
  const Vector3 force(0.0, 0.0, -20.0), left(0.0, 0.05, 0.0);
  run(10.0, balancing_forces(force, left.cross(force)));
  state.q.segment<4>(3) = exp_so3(0.5 * M_PI * Vector3::UnitZ()).coeffs();
  dynamics.update(state.q, state.v, Vector3::UnitZ());
  run(kPeriod, FeetMatrix::Zero(), true, true);
  BOOST_TEST((payload.force() - force).norm() < 1e-3);
  const Vector3 left_after_the_turn(-0.05, 0.0, 0.0);
  BOOST_TEST((payload.moment() - left_after_the_turn.cross(force)).norm() < 1e-3);
}

BOOST_FIXTURE_TEST_CASE(constant_wrench_at_the_start_is_estimated_in_one_tick, PayloadFixture) {
  const Vector3 force(0.0, 2.0, -20.0), moment(1.0, -2.0, 0.0);
  run(kPeriod, balancing_forces(force, moment));
  BOOST_TEST((payload.force() - force).norm() < 1e-9);
  BOOST_TEST((payload.moment() - moment).norm() < 1e-9);
}

BOOST_FIXTURE_TEST_CASE(acceleration_by_the_feet_is_no_external_force, PayloadFixture) {
  const FeetMatrix rest = balancing_forces(Vector3::Zero(), Vector3::Zero());
  run(0.1, rest);
  const Vector3 a(1.0, -2.0, 1.5);
  const FeetMatrix forces = balancing_forces(-robot.mass() * a, Vector3::Zero());
  for (int k = 1; k <= 200; ++k) {
    dynamics.update(state.q, state.v, Vector3::UnitZ());
    dynamics.shift(Vector3::Zero(), kPeriod * k * a);
    payload.update(gains, dynamics, forces, true, false, kPeriod);
  }
  BOOST_TEST(payload.force().norm() < 1e-9);
  // The same motion while the feet only carry the weight: an external push.
  PayloadFixture pushed;
  pushed.run(0.1, rest);
  for (int k = 1; k <= 2000; ++k) {
    pushed.dynamics.update(state.q, state.v, Vector3::UnitZ());
    pushed.dynamics.shift(Vector3::Zero(), kPeriod * k * a);
    pushed.payload.update(gains, pushed.dynamics, rest, true, false, kPeriod);
  }
  BOOST_TEST((pushed.payload.force() - robot.mass() * a).norm() < 0.01 * robot.mass() * a.norm());
}

BOOST_FIXTURE_TEST_CASE(payload_mass_and_com_shift_are_estimated, PayloadFixture) {
  const double mass = 3.0;
  const Vector3 place(0.1, -0.05, 0.0), pull(0.0, 0.0, -mass * kGravity);
  run(1.0, balancing_forces(Vector3::Zero(), Vector3::Zero()));
  run(10.0, balancing_forces(pull, place.cross(pull)));
  BOOST_TEST(std::abs(payload.mass() - mass) < 1e-6);
  const Vector3 shift = mass / (mass + robot.mass()) * place;
  BOOST_TEST((payload.com_shift() - shift).norm() < 1e-6);
}

BOOST_FIXTURE_TEST_CASE(payload_estimate_is_bounded, PayloadFixture) {
  gains.payload_max = 0.5;
  const double most = gains.payload_max * weight;
  for (const double seconds : {kPeriod, 10.0}) {
    payload.reset();
    run(seconds, balancing_forces(Vector3(0.0, 0.0, -3.0 * weight), Vector3(500.0, 0.0, 0.0)));
    BOOST_TEST((payload.force() - Vector3(0.0, 0.0, -most)).norm() < 1e-6);
    BOOST_TEST((payload.moment() - Vector3(0.1 * most, 0.0, 0.0)).norm() < 1e-6);
  }
  // No windup beyond the bound: the estimate starts to decay from the bound.
  run(5.0 * gains.payload_time, balancing_forces(Vector3::Zero(), Vector3::Zero()));
  BOOST_TEST(payload.force().norm() < 0.01 * most);
}

BOOST_FIXTURE_TEST_CASE(payload_estimate_is_held_while_the_feet_are_unloaded, PayloadFixture) {
  const Vector3 force(0.0, 0.0, -20.0);
  run(10.0, balancing_forces(force, Vector3::Zero()));
  run(5.0, FeetMatrix::Zero(), false);
  BOOST_TEST((payload.force() - force).norm() < 1e-6);
  dynamics.update(state.q, state.v, Vector3::UnitZ());
  dynamics.shift(Vector3::Zero(), Vector3(0.0, 0.0, -1.0));  // the robot has fallen meanwhile
  run(kPeriod, FeetMatrix::Zero(), false);
  run(1.0, balancing_forces(force, Vector3::Zero()));
  BOOST_TEST((payload.force() - force).norm() < 1e-6);
  payload.reset();
  BOOST_TEST(payload.force().norm() == 0.0);
  run(1.0, balancing_forces(force, Vector3::Zero()), false);
  BOOST_TEST(payload.force().norm() == 0.0);
}

// The push is the measured minus the planned acceleration, plus the push that the plan counted
// with.
BOOST_AUTO_TEST_CASE(push_is_measured_minus_planned_acceleration_by_the_feet) {
  const Robot robot = quadruped();
  Gains gains = robot.config().gains;
  // The legs do not move, which contradicts the push: trust them less.
  gains.noise_foot_position = 0.01;
  const Vector3 felt(3.0, 1.0, 0.0), planned(1.0, -1.0, 0.0), counted(0.5, 1.5, 0.0);
  const auto push_seen = [&](bool plan_known) {
    StateEstimator estimator(robot);
    estimator.set_gains(gains);
    std::uint32_t tick = 0;
    const auto update = [&](const Vector3& a) {
      LowState report = resting_sample(robot, tick += 2);
      report.imu.accelerometer = {float(a.x()), float(a.y()), float(a.z() + kGravity)};
      BOOST_REQUIRE((estimator.update(report, kPeriod) == Status::kOk));
    };
    for (int k = 0; k < 500; ++k) update(Vector3::Zero());
    Vector6 a_base = Vector6::Zero();
    a_base.head<3>() = planned;
    if (plan_known) estimator.set_planned_motion(a_base, Vector12::Zero(), robot.mass() * counted);
    for (int k = 0; k < 30; ++k) update(felt);
    return Vector3((estimator.state().f_external - estimator.state().f_sustained) / robot.mass());
  };
  BOOST_TEST(push_seen(false).norm() == 0.0);  // no plan to compare with
  const Vector3 seen = push_seen(true), expected = felt - planned + counted;
  const double share = 1.0 - gains.push_dead_band / expected.norm();
  BOOST_TEST((seen - share * expected).norm() < 0.05 * expected.norm());
}

BOOST_AUTO_TEST_CASE(push_estimate_starts_at_the_dead_band_and_is_bounded) {
  Gains gains;
  PushObserver push;
  const auto after = [&](double seconds, const Vector3& unexplained) {
    for (int k = 0; k < seconds / kPeriod; ++k) push.update(gains, unexplained, true, kPeriod);
    return push.acceleration(gains);
  };
  BOOST_TEST(push.acceleration(gains).norm() == 0.0);
  BOOST_TEST(after(1.0, Vector3(0.0, 0.3, -0.3)).norm() == 0.0);
  const Vector3 side(3.0, 0.0, 4.0);
  BOOST_TEST((after(1.0, side) - 0.9 * side).norm() < 1e-6);  // 5 minus the dead band of 0.5
  BOOST_TEST(std::abs(after(1.0, 100.0 * side).norm() - gains.push_max) < 1e-9);
}

// Factor on push_time by size [push_dead_band]; tests/python/test_tune_design.py has the same
// table.
BOOST_AUTO_TEST_CASE(larger_pushes_are_estimated_faster) {
  constexpr double kShares[][2] = {
      {2.9, 1.0}, {3.5, 1.0 / 1.5}, {4.0, 0.5}, {5.0, 0.375}, {20.0, 0.375}};
  Gains gains;
  gains.push_max = 100.0;
  for (const double band : {0.1, 0.5}) {
    gains.push_dead_band = band;
    for (const double push_time : {0.003, 0.016, 0.064}) {
      gains.push_time = push_time;
      for (const auto& [size, share] : kShares) {
        PushObserver push;
        const Vector3 side = size * band * Vector3(0.6, -0.8, 0.0);
        push.update(gains, side, true, kPeriod);
        const double seen = kPeriod / (kPeriod + share * push_time) * size * band;
        const double expected_norm = std::max(0.0, seen - band);
        BOOST_TEST(std::abs(push.acceleration(gains).norm() - expected_norm) < 1e-9);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(accelerometer_dropouts_are_followed_slowly) {
  Gains gains;
  gains.push_dead_band = 0.0;
  PushObserver push;
  const Vector3 drop_out(0.0, 0.0, -kGravity);
  for (int k = 0; k < 8; ++k) push.update(gains, drop_out, true, kPeriod);
  const double slowly = 1.0 - std::pow(1.0 + kPeriod / gains.push_time, -8.0);
  BOOST_TEST((push.acceleration(gains) - slowly * drop_out).norm() < 1e-9);
}

// A body that oscillates because the real delay exceeds the option causes innovations without end.
// They are followed fast for 0.05 s only. One second without them restores the fast response.
BOOST_AUTO_TEST_CASE(persistent_oscillation_is_followed_slowly) {
  Gains gains;
  gains.push_dead_band = 1e-4;
  PushObserver push;
  const auto change = [&](double size) {
    const double before = push.acceleration(gains).x();
    push.update(gains, Vector3(before + size, 0.0, 0.0), true, kPeriod);
    return (push.acceleration(gains).x() - before) / size;
  };
  const auto tolerance = boost::test_tools::tolerance(1e-3);
  double size = 3.0;
  BOOST_TEST(change(size) == 0.25, tolerance);
  for (int k = 0; k < 23; ++k) BOOST_TEST(change(size = -size) == 0.25, tolerance);
  for (int k = 0; k < 200; ++k) BOOST_TEST(change(size = -size) == 1.0 / 9.0, tolerance);
  for (int k = 0; k < 500; ++k) push.update(gains, Vector3::Zero(), true, kPeriod);
  BOOST_TEST(change(size) == 0.25, tolerance);
}

BOOST_AUTO_TEST_SUITE_END()
