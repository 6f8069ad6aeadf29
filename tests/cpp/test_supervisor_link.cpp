// SPDX-License-Identifier: BSD-3-Clause
// A supervisor whose reports come over a link: silence, other robots, robots that stand already.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "scenes.hpp"
#include "surefoot/error.hpp"
#include "surefoot/stand_runner.hpp"

using namespace surefoot;

namespace {

SupervisorOptions options(Start start) {
  SupervisorOptions options;
  options.start = start;
  return options;
}

/// A robot that stands still whatever it is told, and gives the torques it is told.
struct Standing {
  explicit Standing(Start start = Start::kStanding)
      : supervisor(robot, robot.config().gains, options(start)) {
    for (int i = 0; i < kMotors; ++i) {
      report.motorState[i].mode = kModeServo;
      report.motorState[i].temperature = 30;
    }
  }
  void step(int milliseconds = 2) {
    report.tick += milliseconds;
    // Sensors are never quite still.
    report.motorState[3].dq = -report.motorState[3].dq;
    report.imu.gyroscope[2] = 1e-6F * float(report.tick % 7);
    for (int i = 0; i < kMotors; ++i) report.motorState[i].tauEst = last.motorCmd[i].tau;
    last = supervisor.update(report);
  }
  void run(double seconds) {
    for (int i = 0; i < static_cast<int>(500.0 * seconds); ++i) step();
  }
  Robot robot = quadruped();
  Supervisor supervisor;
  LowState report = [this] {
    LowState state = resting_report(robot, 0);
    state.motorState[3].dq = 1e-3F;
    state.imu.gyroscope[2] = 1e-5F;
    return state;
  }();
  LowCmd last = init_low_cmd();
};

/// The same with its legs apart, as if it lay: it is armed and on its way up.
struct Rising : Standing {
  Rising() : Standing(Start::kLying) {
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

BOOST_FIXTURE_TEST_CASE(a_robot_that_stands_is_taken_over_with_its_first_good_report, Standing) {
  report.imu.gyroscope[0] = NAN;
  run(0.1);
  BOOST_TEST(motors_brake(last));
  BOOST_TEST((supervisor.mode() == Mode::kPassive));
  report.imu.gyroscope[0] = 0.0F;
  step();
  BOOST_TEST((supervisor.mode() == Mode::kStand));
  BOOST_TEST(!motors_brake(last));
  BOOST_TEST(supervisor.fresh());
  run(0.5);
  BOOST_TEST((supervisor.mode() == Mode::kStand), to_string(supervisor.reason()));
}

BOOST_FIXTURE_TEST_CASE(one_that_stood_is_taken_over_again_only_when_asked, Standing) {
  run(0.1);
  supervisor.stop();
  run(2.0);
  BOOST_TEST((supervisor.mode() == Mode::kDamping));
  BOOST_TEST((supervisor.arm() == RequestStatus::kAccepted));
  step();
  BOOST_TEST((supervisor.mode() == Mode::kStand));
  BOOST_TEST(!motors_brake(last));
}

BOOST_FIXTURE_TEST_CASE(a_stop_undoes_what_waits, Standing) {
  run(0.1);
  supervisor.stop();
  run(0.1);
  BOOST_TEST((supervisor.arm() == RequestStatus::kAccepted));
  supervisor.stop();
  run(0.1);
  BOOST_TEST((supervisor.mode() == Mode::kDamping));
}

BOOST_FIXTURE_TEST_CASE(without_reports_the_last_command_lives_ten_milliseconds, Rising) {
  const LowCmd before = last;
  for (const double age : {0.002, 0.006, 0.010}) {
    const LowCmd& command = supervisor.bridge(age);
    BOOST_TEST(command.motorCmd[4].tau == before.motorCmd[4].tau);
    BOOST_TEST(!motors_brake(command));
    BOOST_TEST(!supervisor.fresh());
  }
  BOOST_TEST(motors_brake(supervisor.bridge(0.0101)));
  BOOST_TEST(motors_brake(supervisor.bridge(0.0201)));
  BOOST_TEST((supervisor.request(Mode::kSit) == RequestStatus::kNoState));
  BOOST_TEST((supervisor.arm() == RequestStatus::kNoState));
  step();
  BOOST_TEST((supervisor.mode() == Mode::kRise));
  BOOST_TEST(!motors_brake(last));
  BOOST_TEST((supervisor.request(Mode::kSit) == RequestStatus::kAccepted));
}

// Of 14 ms between reports a loop at 500 Hz bridges the most; none of them has a number.
BOOST_FIXTURE_TEST_CASE(bad_reports_far_apart_damp_and_latch, Standing) {
  run(0.1);
  report.imu.gyroscope[0] = NAN;
  for (int k = 0; k < 2; ++k) {
    for (const double age : {0.002, 0.004, 0.006, 0.008, 0.010, 0.012}) supervisor.bridge(age);
    report.tick += 14;
    last = supervisor.update(report);
  }
  BOOST_TEST((supervisor.mode() == Mode::kDamping));
  BOOST_TEST((supervisor.reason() == FaultId::kStateNotFinite), to_string(supervisor.reason()));
  report.imu.gyroscope[0] = 0.0F;
  step();
  BOOST_TEST(motors_brake(last));
}

BOOST_FIXTURE_TEST_CASE(reports_so_far_apart_that_none_is_believed_latch, Standing) {
  run(0.1);
  for (int k = 0; k < 8; ++k) {
    step(17);
    for (const double age : {0.004, 0.008, 0.012, 0.016}) supervisor.bridge(age);
  }
  BOOST_TEST((supervisor.mode() == Mode::kDamping));
  BOOST_TEST((supervisor.reason() == FaultId::kStaleTick), to_string(supervisor.reason()));
}

BOOST_FIXTURE_TEST_CASE(bad_reports_and_silence_share_the_ten_milliseconds, Standing) {
  run(0.1);
  report.imu.gyroscope[0] = NAN;
  for (int k = 0; k < 5; ++k) step();
  BOOST_TEST(!motors_brake(last));  // 10 ms old
  BOOST_TEST(motors_brake(supervisor.bridge(0.002)));
}

BOOST_FIXTURE_TEST_CASE(torques_come_back_from_damping_at_their_rate, Standing) {
  run(0.5);
  const LowCmd before = last;
  BOOST_TEST(motors_brake(supervisor.bridge(0.0101)));
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

BOOST_FIXTURE_TEST_CASE(nothing_waits_for_a_robot_that_is_not_heard, Standing) {
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
  supervisor.bridge(0.0201);
  step();
  BOOST_TEST((supervisor.mode() == Mode::kDamping));
}

BOOST_AUTO_TEST_CASE(one_that_lay_unheard_is_disarmed_though_its_gap_was_bridged) {
  Standing robot(Start::kLying);
  robot.run(1.2);
  robot.supervisor.arm();
  robot.step();
  BOOST_TEST(robot.supervisor.armed());
  robot.supervisor.bridge(0.03);
  robot.step(5000);
  robot.step();
  BOOST_TEST(!robot.supervisor.armed());
}

BOOST_FIXTURE_TEST_CASE(springs_that_fade_out_end_with_the_moment_they_belong_to, Rising) {
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

BOOST_FIXTURE_TEST_CASE(a_stop_needs_no_report, Rising) {
  supervisor.stop();
  BOOST_TEST(motors_brake(supervisor.bridge(0.002)));
  BOOST_TEST((supervisor.mode() == Mode::kDamping));
  BOOST_TEST((supervisor.reason() == FaultId::kStop));
}

BOOST_FIXTURE_TEST_CASE(a_robot_that_is_lost_damps_until_it_is_armed_anew, Rising) {
  supervisor.request(Mode::kSit);
  supervisor.lose();
  BOOST_TEST((supervisor.mode() == Mode::kDamping));
  BOOST_TEST((supervisor.reason() == FaultId::kLink));
  BOOST_TEST((supervisor.arm() == RequestStatus::kNoState));
  report.tick = 7;  // it began anew
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

BOOST_FIXTURE_TEST_CASE(a_gap_between_reports_is_the_links_to_judge, Rising) {
  supervisor.count_reports(1.0, 0.0);
  step(50);  // this program stood still, and the robot went on
  step();
  step();
  BOOST_TEST((supervisor.mode() == Mode::kRise), to_string(supervisor.reason()));
  BOOST_TEST(!motors_brake(last));
}

BOOST_FIXTURE_TEST_CASE(who_damps_for_gaps_in_the_link_is_no_second_program, Rising) {
  supervisor.count_reports(1.0, 0.0);
  for (int k = 0; k < 100; ++k) {
    step(12);
    for (const int i : {2, 8}) report.motorState[i].tauEst += k % 2 == 0 ? 2.0F : -2.0F;
    report.tick += 2;
    report.imu.gyroscope[2] = 1e-6F * float(report.tick % 7);
    last = supervisor.update(report);
    supervisor.bridge(0.011);
  }
  BOOST_TEST(!supervisor.faults().has(FaultId::kOverridden));
  BOOST_TEST((supervisor.mode() == Mode::kRise), to_string(supervisor.reason()));
}

BOOST_FIXTURE_TEST_CASE(without_a_link_a_tenth_of_a_second_missing_latches, Rising) {
  step(50);
  step();
  BOOST_TEST((supervisor.mode() == Mode::kRise), to_string(supervisor.reason()));
  step(150);
  step();
  BOOST_TEST((supervisor.mode() == Mode::kDamping));
  BOOST_TEST((supervisor.reason() == FaultId::kStaleTick));
}

BOOST_FIXTURE_TEST_CASE(a_loop_of_a_hundred_hertz_may_jitter, Standing) {
  for (int k = 0; k < 300; ++k) step(9 + k % 4);
  BOOST_TEST((supervisor.mode() == Mode::kStand), to_string(supervisor.reason()));
  BOOST_TEST(supervisor.faults().count[static_cast<int>(FaultId::kStaleTick)] == 0U);
}

BOOST_AUTO_TEST_CASE(one_that_was_never_armed_has_nothing_to_lose) {
  Standing robot(Start::kLying);
  robot.run(0.1);
  robot.supervisor.lose();
  BOOST_TEST((robot.supervisor.mode() == Mode::kPassive));
}

BOOST_AUTO_TEST_CASE(what_the_link_counts_is_what_arming_goes_by) {
  Standing robot(Start::kLying);
  // Two or three milliseconds from one report that is handed on to the next; none is missing.
  for (int k = 0; k < 600; ++k) {
    const int milliseconds = 1 + k % 3;
    robot.supervisor.count_reports(milliseconds, 0);
    robot.step(milliseconds);
  }
  BOOST_TEST(robot.supervisor.arming().ready);
  for (int k = 0; k < 50; ++k) {
    robot.supervisor.count_reports(1, 1);
    robot.step();
  }
  BOOST_TEST(!robot.supervisor.arming()[ArmingCheckId::kLink].passed);
  BOOST_TEST(!robot.supervisor.arming().ready);
}

BOOST_AUTO_TEST_CASE(a_real_robot_is_not_taken_over_unchecked) {
  const Robot robot = quadruped();
  UdpLinkOptions link;
  link.host = "10.1.2.3";
  link.real_robot = true;
  RunOptions run;
  const auto says = [](const char* word) {
    return [word](const Error& e) { return std::string(e.what()).find(word) != std::string::npos; };
  };
  const auto make = [&] { StandRunner(robot, robot.config().gains, {}, link, run); };
  BOOST_CHECK_EXCEPTION(make(), Error, says("arming"));
  run.start = Start::kLying;
  make();
  run.power_level = 0;
  BOOST_CHECK_EXCEPTION(make(), Error, says("power_level"));
}

BOOST_FIXTURE_TEST_CASE(an_age_that_is_none_damps_and_refuses_requests, Rising) {
  for (const double age : {-0.001, std::nan("")}) {
    step();
    BOOST_REQUIRE(!motors_brake(last));
    BOOST_TEST(motors_brake(supervisor.bridge(age)));
    BOOST_TEST((supervisor.request(Mode::kSit) == RequestStatus::kNoState));
  }
}

BOOST_AUTO_TEST_CASE(a_runner_runs_once) {
  const Robot robot = quadruped();
  UdpLinkOptions link;
  link.port = 48123;  // not a robot's
  StandRunner runner(robot, robot.config().gains, {}, link, {});
  runner.stop();
  runner.run();
  BOOST_CHECK_THROW(runner.run(), Error);
}

BOOST_AUTO_TEST_SUITE_END()
