// SPDX-License-Identifier: BSD-3-Clause
#include <boost/test/unit_test.hpp>

#include "supervisor/modes/torque_rate_limiter.hpp"

using namespace surefoot;

namespace {

constexpr double kTick = 0.002, kLimit = 20.0;
constexpr double kStep = TorqueRateLimiter::kMaxRate * kTick * kLimit;  // [N.m] largest per tick

struct Rate {
  TorqueRateLimiter rate{Vector12::Constant(kLimit)};
  Vector12 tau = Vector12::Zero(), kd = Vector12::Constant(2.0), dq = Vector12::Zero();

  Rate() { rate.set_damping_only(kd[0]); }
  // Return the torque of motor 0 at this speed, including its own damping [N.m].
  double motor_torque() const { return tau[0] - kd[0] * dq[0]; }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(torque_rate)

BOOST_FIXTURE_TEST_CASE(torque_change_is_limited_and_keeps_its_direction, Rate) {
  tau[0] = 10.0;
  tau[1] = -5.0;
  BOOST_TEST(rate.limit(tau, kd, dq, kTick));
  BOOST_TEST(std::abs(tau[0] - kStep) < 1e-12);
  BOOST_TEST(std::abs(tau[1] + 0.5 * kStep) < 1e-12);
  BOOST_TEST(!rate.limit(tau, kd, dq, kTick));
}

BOOST_FIXTURE_TEST_CASE(a_leg_does_not_delay_the_others, Rate) {
  tau[0] = 15.0;           // FR
  tau[3] = 0.9 * kStep;    // FL
  tau[11] = -1.1 * kStep;  // RL
  BOOST_TEST(rate.limit(tau, kd, dq, kTick));
  BOOST_TEST(std::abs(tau[0] - kStep) < 1e-12);
  BOOST_TEST(tau[3] == 0.9 * kStep);
  BOOST_TEST(std::abs(tau[11] + kStep) < 1e-12);
}

BOOST_FIXTURE_TEST_CASE(period_of_0_keeps_the_torques, Rate) {
  tau[0] = 15.0;
  BOOST_TEST(rate.limit(tau, kd, dq, 0.0));
  BOOST_TEST(tau.isZero(0.0));
}

BOOST_FIXTURE_TEST_CASE(reduced_damping_counts_as_torque_change, Rate) {
  dq[0] = 6.0;
  rate.limit(tau, kd, dq, kTick);
  const double before = motor_torque();
  kd.setConstant(1.0);  // removes 6 N.m of braking at once
  BOOST_TEST(rate.limit(tau, kd, dq, kTick));
  BOOST_TEST(std::abs(motor_torque() - before) < kStep + 1e-12);
  BOOST_TEST(motor_torque() > before);
  tau.setZero();
  for (int k = 0; k < 3; ++k) {
    rate.limit(tau, kd, dq, kTick);
    tau.setZero();
  }
  BOOST_TEST(!rate.limit(tau, kd, dq, kTick));  // the target is reached
}

// As after a gap in the samples that is longer than the command hold.
BOOST_FIXTURE_TEST_CASE(damping_ends_within_the_torque_rate, Rate) {
  dq[0] = 6.0;
  tau[0] = -3.0;
  rate.limit(tau, kd, dq, kTick);
  rate.set_damping_only(3.0);
  const double before = -3.0 * dq[0];
  kd.setZero();
  BOOST_TEST(rate.limit(tau, kd, dq, kTick));
  BOOST_TEST(std::abs(motor_torque() - before) < kStep + 1e-12);
}

// A fast joint brakes at the limit of its motor, because its damping requests more than that.
BOOST_FIXTURE_TEST_CASE(command_after_damping_is_within_motor_limits, Rate) {
  for (const double speed : {15.0, -15.0}) {
    dq[0] = speed;
    rate.set_damping_only(3.0);
    tau.setZero();
    kd.setZero();
    BOOST_TEST(rate.limit(tau, kd, dq, kTick));
    BOOST_TEST(std::abs(tau[0]) <= kLimit);
    BOOST_TEST(std::abs(tau[0]) > kLimit - 1.01 * kStep);  // braking continues
  }
}

// Damping with the same gain continues without added torques, although it exceeds the motor limit.
BOOST_FIXTURE_TEST_CASE(constant_damping_beyond_the_motor_limit_is_unchanged, Rate) {
  dq[0] = 15.0;
  kd.setConstant(3.0);
  rate.set_damping_only(3.0);
  for (int k = 0; k < 3; ++k) {
    tau.setZero();
    BOOST_TEST(!rate.limit(tau, kd, dq, kTick));
    BOOST_TEST(tau[0] == 0.0);
  }
}

// While the damping gain is constant, joint speeds have no effect, even if they are wrong.
BOOST_FIXTURE_TEST_CASE(wrong_joint_speeds_cause_no_torque_jump, Rate) {
  rate.set_damping_only(kd[0]);
  double before = 0.0;
  for (int k = 0; k < 40; ++k) {
    tau[0] = k < 20 ? 15.0 : -15.0;
    dq[0] = k % 3 == 0 ? 60.0 : -60.0;
    rate.limit(tau, kd, dq, kTick);
    BOOST_TEST(std::abs(tau[0] - before) < kStep + 1e-12);
    before = tau[0];
  }
}

// One sample in 25 has 25 rad/s, while the damping fades and the torques change at the largest
// rate.
BOOST_FIXTURE_TEST_CASE(speed_spike_of_one_sample_causes_no_torque_step, Rate) {
  double before = 0.0;
  for (int k = 0; k < 50; ++k) {
    tau[0] = 18.0;
    dq[0] = k % 25 == 3 ? 25.0 : 0.5;
    kd.setConstant(2.0 - 0.04 * k);
    rate.limit(tau, kd, dq, kTick);
    const double fades = 0.04 * 0.5;  // [N.m] change of damping torque at the true speed
    BOOST_TEST(std::abs(tau[0] - before) < kStep + fades + 1e-12);
    before = tau[0];
  }
}

BOOST_FIXTURE_TEST_CASE(unknown_previous_torque_is_not_limited, Rate) {
  dq[0] = 6.0;
  kd.setConstant(15.0);
  rate.reset();
  BOOST_TEST(!rate.limit(tau, kd, dq, kTick));
}

BOOST_AUTO_TEST_SUITE_END()
