// SPDX-License-Identifier: BSD-3-Clause
// A supervisor with samples from a link: gaps, link loss, and robots that already stand.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "robot_states.hpp"
#include "surefoot/error.hpp"
#include "surefoot/runner.hpp"

using namespace surefoot;

namespace {

SupervisorOptions options(Start start) {
  SupervisorOptions options;
  options.start = start;
  return options;
}

/// A robot that stands still whatever its commands are, and reports the commanded torques.
struct StandingRobot {
  explicit StandingRobot(Start start = Start::kStanding)
      : supervisor(robot, robot.config().gains, options(start)) {
    for (int i = 0; i < kMotors; ++i) {
      report.motorState[i].mode = kModeServo;
      report.motorState[i].temperature = 30;
    }
  }
  void step(int milliseconds = 2) {
    report.tick += milliseconds;
    // Real sensor values change in every sample.
    report.motorState[3].dq = -report.motorState[3].dq;
    report.imu.gyroscope[2] = 1e-6F * float(report.tick % 7);
    report.imu.accelerometer[2] = static_cast<float>(kGravity) + 1e-4F * float(report.tick % 7);
    for (int i = 0; i < kMotors; ++i) report.motorState[i].tauEst = last.motorCmd[i].tau;
    last = supervisor.update(report);
  }
  void run(double seconds) {
    for (int i = 0; i < static_cast<int>(500.0 * seconds); ++i) step();
  }
  Robot robot = quadruped();
  Supervisor supervisor;
  LowState report = [this] {
    LowState state = resting_sample(robot, 0);
    state.motorState[3].dq = 1e-3F;
    state.imu.gyroscope[2] = 1e-5F;
    return state;
  }();
  LowCmd last = init_low_cmd();
};

/// The same robot with spread legs, as if it lay: armed and rising.
struct RisingRobot : StandingRobot {
  RisingRobot() : StandingRobot(Start::kLying) {
    for (int leg = 0; leg < kLegs; ++leg) {
      report.motorState[kLegJoints * leg].q += leg % 2 == 0 ? -0.5F : 0.5F;
    }
    run(1.2);
    supervisor.arm();
    step();
    supervisor.request(Mode::kRise);
    run(0.3);
    BOOST_REQUIRE((supervisor.mode() == Mode::kRise));
    BOOST_REQUIRE(!motors_brake(last));
  }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(supervisor_link)

BOOST_FIXTURE_TEST_CASE(standing_robot_is_taken_over_at_its_first_valid_sample, StandingRobot) {
  report.imu.gyroscope[0] = NAN;
  run(0.1);
  BOOST_TEST(motors_brake(last));
  BOOST_TEST((supervisor.mode() == Mode::kPassive));
  report.imu.gyroscope[0] = 0.0F;
  step();
  BOOST_TEST((supervisor.mode() == Mode::kStand));
  BOOST_TEST(!motors_brake(last));
  BOOST_TEST(supervisor.command_is_fresh());
  run(0.5);
  BOOST_TEST((supervisor.mode() == Mode::kStand), to_string(supervisor.damping_fault()));
}

BOOST_FIXTURE_TEST_CASE(stopped_standing_robot_is_taken_over_only_after_arming, StandingRobot) {
  run(0.1);
  supervisor.stop();
  run(2.0);
  BOOST_TEST((supervisor.mode() == Mode::kDamping));
  BOOST_TEST((supervisor.arm() == RequestStatus::kAccepted));
  step();
  BOOST_TEST((supervisor.mode() == Mode::kStand));
  BOOST_TEST(!motors_brake(last));
}

BOOST_AUTO_TEST_CASE(conflict_refuses_arming_and_rising_by_name_until_it_ends) {
  StandingRobot lying(Start::kLying);
  lying.supervisor.report_conflict(true);
  lying.run(1.2);
  BOOST_TEST((lying.supervisor.arm() == RequestStatus::kNotReady));
  BOOST_TEST(describe_failures(lying.supervisor.arming(), lying.robot.config()) ==
             "conflict: another program commands the robot, or a second robot sends LowStates; "
             "end it");
  lying.supervisor.report_conflict(false);
  lying.run(1.2);
  BOOST_TEST((lying.supervisor.arm() == RequestStatus::kAccepted));
  lying.step();
  lying.supervisor.report_conflict(true);
  lying.step();
  BOOST_TEST((lying.supervisor.request(Mode::kRise) == RequestStatus::kNotReady));
}

BOOST_FIXTURE_TEST_CASE(standing_robot_is_not_taken_over_in_a_conflict, StandingRobot) {
  supervisor.report_conflict(true);
  run(0.1);
  BOOST_TEST((supervisor.mode() == Mode::kPassive));
  BOOST_TEST((supervisor.arm() == RequestStatus::kNotReady));
  supervisor.report_conflict(false);
  step();
  BOOST_TEST((supervisor.mode() == Mode::kStand));
}

BOOST_FIXTURE_TEST_CASE(stop_cancels_a_pending_arming, StandingRobot) {
  run(0.1);
  supervisor.stop();
  run(0.1);
  BOOST_TEST((supervisor.arm() == RequestStatus::kAccepted));
  supervisor.stop();
  run(0.1);
  BOOST_TEST((supervisor.mode() == Mode::kDamping));
}

BOOST_FIXTURE_TEST_CASE(missing_samples_hold_the_last_command_for_10_ms, RisingRobot) {
  const LowCmd before = last;
  for (const double age : {0.002, 0.006, 0.010}) {
    const LowCmd& command = supervisor.update_without_state(age);
    BOOST_TEST(command.motorCmd[4].tau == before.motorCmd[4].tau);
    BOOST_TEST(!motors_brake(command));
    BOOST_TEST(!supervisor.command_is_fresh());
  }
  BOOST_TEST(motors_brake(supervisor.update_without_state(0.0101)));
  BOOST_TEST(motors_brake(supervisor.update_without_state(0.0201)));
  BOOST_TEST((supervisor.request(Mode::kSit) == RequestStatus::kNoState));
  BOOST_TEST((supervisor.arm() == RequestStatus::kNoState));
  step();
  BOOST_TEST((supervisor.mode() == Mode::kRise));
  BOOST_TEST(!motors_brake(last));
  BOOST_TEST((supervisor.request(Mode::kSit) == RequestStatus::kAccepted));
}

// A loop at 500 Hz bridges most of the 14 ms between two samples, and each sample is NaN.
BOOST_FIXTURE_TEST_CASE(bad_samples_14_ms_apart_latch_damping, StandingRobot) {
  run(0.1);
  report.imu.gyroscope[0] = NAN;
  for (int k = 0; k < 2; ++k) {
    for (const double age : {0.002, 0.004, 0.006, 0.008, 0.010, 0.012})
      supervisor.update_without_state(age);
    report.tick += 14;
    last = supervisor.update(report);
  }
  BOOST_TEST((supervisor.mode() == Mode::kDamping));
  BOOST_TEST((supervisor.damping_fault() == FaultId::kStateNotFinite),
             to_string(supervisor.damping_fault()));
  report.imu.gyroscope[0] = 0.0F;
  step();
  BOOST_TEST(motors_brake(last));
}

BOOST_FIXTURE_TEST_CASE(samples_17_ms_apart_latch_damping, StandingRobot) {
  run(0.1);
  for (int k = 0; k < 8; ++k) {
    step(17);
    for (const double age : {0.004, 0.008, 0.012, 0.016}) supervisor.update_without_state(age);
  }
  BOOST_TEST((supervisor.mode() == Mode::kDamping));
  BOOST_TEST((supervisor.damping_fault() == FaultId::kStaleTick),
             to_string(supervisor.damping_fault()));
}

BOOST_FIXTURE_TEST_CASE(bad_and_missing_samples_share_the_10_ms_hold, StandingRobot) {
  run(0.1);
  report.imu.gyroscope[0] = NAN;
  for (int k = 0; k < 5; ++k) step();
  BOOST_TEST(!motors_brake(last));  // 10 ms old
  BOOST_TEST(motors_brake(supervisor.update_without_state(0.002)));
}

BOOST_FIXTURE_TEST_CASE(torques_return_from_damping_at_the_limited_rate, StandingRobot) {
  run(0.5);
  const LowCmd before = last;
  BOOST_TEST(motors_brake(supervisor.update_without_state(0.0101)));
  LowCmd sent = init_low_cmd();  // no torque
  for (int k = 0; k < 20; ++k) {
    step();
    for (int i = 0; i < kMotors; ++i) {
      const double change = std::abs(last.motorCmd[i].tau - sent.motorCmd[i].tau);
      BOOST_TEST(change < 0.0951 * robot.config().tau_max[i]);
    }
    sent = last;
  }
  for (int i = 0; i < kMotors; ++i) {
    const double off = last.motorCmd[i].tau - before.motorCmd[i].tau;
    BOOST_TEST(std::abs(off) < 0.05 * robot.config().tau_max[i]);
  }
}

BOOST_FIXTURE_TEST_CASE(missing_state_cancels_pending_requests, StandingRobot) {
  run(0.1);
  supervisor.stop();
  run(0.1);
  BOOST_TEST((supervisor.arm() == RequestStatus::kAccepted));
  report.imu.gyroscope[0] = NAN;
  run(0.1);
  BOOST_TEST((supervisor.arm() == RequestStatus::kNoState));
  report.imu.gyroscope[0] = 0.0F;
  run(0.1);
  BOOST_TEST((supervisor.mode() == Mode::kDamping));
  BOOST_TEST((supervisor.arm() == RequestStatus::kAccepted));
  supervisor.update_without_state(0.0201);
  step();
  BOOST_TEST((supervisor.mode() == Mode::kDamping));
}

BOOST_AUTO_TEST_CASE(lying_robot_is_disarmed_after_a_5_s_gap) {
  StandingRobot robot(Start::kLying);
  robot.run(1.2);
  robot.supervisor.arm();
  robot.step();
  BOOST_TEST(robot.supervisor.armed());
  robot.supervisor.update_without_state(0.03);
  robot.step(5000);
  robot.step();
  BOOST_TEST(!robot.supervisor.armed());
}

BOOST_FIXTURE_TEST_CASE(spring_fade_out_ends_after_a_10_s_gap, RisingRobot) {
  BOOST_TEST((supervisor.request(Mode::kSit) == RequestStatus::kAccepted));
  step();
  BOOST_TEST((supervisor.mode() == Mode::kPassive));
  BOOST_TEST(!motors_brake(last));
  for (int k = 0; k < 2; ++k) {
    step(k == 0 ? 10000 : 2);
    BOOST_TEST(motors_brake(last));
    BOOST_TEST(!supervisor.armed());
  }
}

BOOST_FIXTURE_TEST_CASE(stop_acts_without_a_sample, RisingRobot) {
  supervisor.stop();
  BOOST_TEST(motors_brake(supervisor.update_without_state(0.002)));
  BOOST_TEST((supervisor.mode() == Mode::kDamping));
  BOOST_TEST((supervisor.damping_fault() == FaultId::kStop));
}

BOOST_FIXTURE_TEST_CASE(lost_link_damps_until_armed_again, RisingRobot) {
  supervisor.request(Mode::kSit);
  supervisor.report_link_lost();
  BOOST_TEST((supervisor.mode() == Mode::kDamping));
  BOOST_TEST((supervisor.damping_fault() == FaultId::kLink));
  BOOST_TEST((supervisor.arm() == RequestStatus::kNoState));
  report.tick = 7;  // the robot has restarted
  step();
  BOOST_TEST(motors_brake(last));
  BOOST_TEST((supervisor.arm() == RequestStatus::kNotReady));
  run(1.2);
  BOOST_TEST((supervisor.mode() == Mode::kDamping));
  BOOST_TEST((supervisor.arm() == RequestStatus::kAccepted));
  step();
  BOOST_TEST((supervisor.mode() == Mode::kPassive));
  BOOST_TEST((supervisor.request(Mode::kRise) == RequestStatus::kAccepted));
  run(0.1);
  BOOST_TEST((supervisor.mode() == Mode::kRise));
}

BOOST_FIXTURE_TEST_CASE(sample_gap_is_accepted_when_the_link_counts_samples, RisingRobot) {
  supervisor.count_samples(1.0, 0.0);
  step(50);  // this process was stopped while the robot continued
  step();
  step();
  BOOST_TEST((supervisor.mode() == Mode::kRise), to_string(supervisor.damping_fault()));
  BOOST_TEST(!motors_brake(last));
}

BOOST_FIXTURE_TEST_CASE(damping_during_link_gaps_is_not_reported_as_override, RisingRobot) {
  supervisor.count_samples(1.0, 0.0);
  for (int k = 0; k < 100; ++k) {
    step(12);
    for (const int i : {2, 8}) report.motorState[i].tauEst += k % 2 == 0 ? 2.0F : -2.0F;
    report.tick += 2;
    report.imu.gyroscope[2] = 1e-6F * float(report.tick % 7);
    last = supervisor.update(report);
    supervisor.update_without_state(0.011);
  }
  BOOST_TEST(!supervisor.faults().has(FaultId::kOverridden));
  BOOST_TEST((supervisor.mode() == Mode::kRise), to_string(supervisor.damping_fault()));
}

BOOST_FIXTURE_TEST_CASE(gap_over_100_ms_without_a_link_latches_damping, RisingRobot) {
  step(50);
  step();
  BOOST_TEST((supervisor.mode() == Mode::kRise), to_string(supervisor.damping_fault()));
  step(150);
  step();
  BOOST_TEST((supervisor.mode() == Mode::kDamping));
  BOOST_TEST((supervisor.damping_fault() == FaultId::kStaleTick));
}

BOOST_FIXTURE_TEST_CASE(samples_at_100_hz_may_jitter_by_3_ms, StandingRobot) {
  for (int k = 0; k < 300; ++k) step(9 + k % 4);
  BOOST_TEST((supervisor.mode() == Mode::kStand), to_string(supervisor.damping_fault()));
  BOOST_TEST(supervisor.faults().count[static_cast<int>(FaultId::kStaleTick)] == 0U);
}

BOOST_AUTO_TEST_CASE(link_loss_of_an_unarmed_robot_keeps_it_passive) {
  StandingRobot robot(Start::kLying);
  robot.run(0.1);
  robot.supervisor.report_link_lost();
  BOOST_TEST((robot.supervisor.mode() == Mode::kPassive));
}

BOOST_AUTO_TEST_CASE(arming_uses_the_sample_counts_of_the_link) {
  StandingRobot robot(Start::kLying);
  // One to three milliseconds pass between the samples that the supervisor receives; none is
  // missing.
  for (int k = 0; k < 600; ++k) {
    const int milliseconds = 1 + k % 3;
    robot.supervisor.count_samples(milliseconds, 0);
    robot.step(milliseconds);
  }
  BOOST_TEST(robot.supervisor.arming().ready);
  for (int k = 0; k < 50; ++k) {
    robot.supervisor.count_samples(1, 1);
    robot.step();
  }
  BOOST_TEST(!robot.supervisor.arming()[ArmingCheckId::kLink].passed);
  BOOST_TEST(!robot.supervisor.arming().ready);
}

BOOST_AUTO_TEST_CASE(real_robot_requires_arming_and_a_power_level) {
  const Robot robot = quadruped();
  UdpLinkOptions link;
  link.host = "10.1.2.3";
  link.real_robot = true;
  RunOptions run;
  const auto contains_text = [](const char* word) {
    return [word](const Error& e) { return std::string(e.what()).find(word) != std::string::npos; };
  };
  const auto make = [&] { Runner(robot, robot.config().gains, {}, link, run); };
  BOOST_CHECK_EXCEPTION(make(), Error, contains_text("arming"));
  run.start = Start::kLying;
  make();
  run.power_level = 0;
  BOOST_CHECK_EXCEPTION(make(), Error, contains_text("power_level"));
}

BOOST_FIXTURE_TEST_CASE(invalid_age_damps_and_refuses_requests, RisingRobot) {
  for (const double age : {-0.001, std::nan("")}) {
    step();
    BOOST_REQUIRE(!motors_brake(last));
    BOOST_TEST(motors_brake(supervisor.update_without_state(age)));
    BOOST_TEST((supervisor.request(Mode::kSit) == RequestStatus::kNoState));
  }
}

BOOST_AUTO_TEST_CASE(runner_cannot_run_twice) {
  const Robot robot = quadruped();
  UdpLinkOptions link;
  link.port = 48123;  // no robot uses this port
  Runner runner(robot, robot.config().gains, {}, link, {});
  runner.stop();
  runner.run();
  BOOST_CHECK_THROW(runner.run(), Error);
}

BOOST_AUTO_TEST_SUITE_END()
