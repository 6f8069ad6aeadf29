// SPDX-License-Identifier: BSD-3-Clause
#include <boost/test/unit_test.hpp>
#include <thread>

#include "robot_states.hpp"
#include "supervisor/common/seqlock.hpp"
#include "supervisor/getting_up/folding/leg_folding.hpp"
#include "supervisor/getting_up/rise_motion.hpp"
#include "supervisor/getting_up/rise_plan.hpp"
#include "surefoot/error.hpp"
#include "surefoot/supervisor.hpp"
#include "surefoot/wireless_remote.hpp"

using namespace surefoot;

namespace {

/// A robot at rest, with hips so far out that it counts as lying, and a sample every 2 ms. Commands
/// do not move it.
struct RestingRobot {
  Robot robot = quadruped();
  Supervisor supervisor;
  LowState report = resting_sample(robot, 0);
  LowCmd last = init_low_cmd();
  float lateral_gravity = 0.0F;  ///< [m/s^2] gravity along the accelerometer's y axis
  explicit RestingRobot(const SupervisorOptions& options = {})
      : supervisor(robot, robot.config().gains, options) {
    for (int i = 0; i < kMotors; ++i) {
      report.motorState[i].mode = kModeServo;
      report.motorState[i].temperature = 30;
    }
    turn_hips(0.5F);
  }
  void turn_hips(float angle) {
    for (int leg = 0; leg < kLegs; ++leg) {
      report.motorState[kLegJoints * leg].q += leg % 2 == 0 ? -angle : angle;
    }
  }
  void run(double seconds) {
    for (int i = 0; i < static_cast<int>(500.0 * seconds); ++i) {
      step();
    }
  }
  /// Run one tick. Sensor values change a little, and motors report the commanded torques.
  void step() {
    report.tick += 2;
    report.imu.gyroscope[2] = report.tick % 4 == 0 ? 1e-5F : -1e-5F;
    report.imu.accelerometer[1] = lateral_gravity + report.imu.gyroscope[2];
    report.motorState[3].dq = report.tick % 4 == 0 ? 1e-3F : -1e-3F;
    for (int i = 0; i < kMotors; ++i) report.motorState[i].tauEst = last.motorCmd[i].tau;
    last = supervisor.update(report);
  }
  /// Move the hip of FR as a rise would: if no leg of a rising robot moves, it counts as another
  /// robot.
  void move_hip() {
    run(0.55);  // the light leg check comes first
    for (int i = 0; i < 250; ++i) {
      report.motorState[0].q += 0.002F;
      report.motorState[0].dq = 1.0F;
      step();
    }
    report.motorState[0].dq = 0.0F;
  }
  /// Roll the body over its right side by `angle` [rad] at 1.5 rad/s; all sensors agree.
  void roll(float angle) {
    constexpr float kRate = 1.5F, kStep = 0.002F * kRate, kG = static_cast<float>(kGravity);
    report.imu.gyroscope[0] = kRate;
    for (float turned = 0.0F; turned < angle; turned += kStep) {
      const float x = 2.0F * std::asin(report.imu.quaternion[1]) + kStep;
      report.imu.quaternion = {std::cos(0.5F * x), std::sin(0.5F * x), 0.0F, 0.0F};
      lateral_gravity = kG * std::sin(x);
      report.imu.accelerometer[2] = kG * std::cos(x);
      step();
    }
    report.imu.gyroscope[0] = 0.0F;
  }
  std::string failures() const { return describe_failures(supervisor.arming(), robot.config()); }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(supervisor)

BOOST_FIXTURE_TEST_CASE(arming_requires_all_checks_for_1_s, RestingRobot) {
  BOOST_TEST((supervisor.arm() == RequestStatus::kNoState));
  run(0.9);
  BOOST_TEST(failures() == "");
  BOOST_TEST((supervisor.arm() == RequestStatus::kNotReady));
  run(0.2);
  BOOST_TEST((supervisor.arm() == RequestStatus::kAccepted));
  BOOST_TEST(!supervisor.armed());
  run(0.002);
  BOOST_TEST(supervisor.armed());
  BOOST_TEST(motors_brake(last));
}

// arming().ready and arm() agree, and a refusal always names a check.
BOOST_FIXTURE_TEST_CASE(blocking_fault_is_listed_among_failed_arming_checks, RestingRobot) {
  run(1.2);
  const auto turning = report.imu.gyroscope;
  report.imu.gyroscope[0] = 3.0F;
  run(0.3);
  report.imu.gyroscope = turning;
  int named = 0;
  for (int k = 0; k < 2000; ++k) {
    run(0.002);
    if (supervisor.arming().ready) break;  // arm() would succeed
    const RequestStatus said = supervisor.arm();
    BOOST_REQUIRE((said == RequestStatus::kNotReady));
    named += failures() == "fault: gyroscope keeps the robot down, expected no such fault";
  }
  BOOST_TEST(named > 0);
  BOOST_TEST((supervisor.arm() == RequestStatus::kAccepted));
}

BOOST_FIXTURE_TEST_CASE(failed_arming_checks_are_named, RestingRobot) {
  const LowState good = report;
  const auto expect = [&](const char* words, double rest = 1.3) {
    run(1.2);
    BOOST_TEST(failures().find(words) != std::string::npos, failures() << " has no " << words);
    BOOST_TEST((supervisor.arm() == RequestStatus::kNotReady));
    const std::uint32_t tick = report.tick;
    report = good;
    report.tick = tick;
    run(rest);
    BOOST_TEST(supervisor.arming().ready, failures());
  };
  run(0.1);
  report.motorState[RR_2].temperature = 71;
  expect("temperature: RR_2 at 71 deg C, expected below 60");
  report.motorState[FL_1].mode = 0x08;
  expect("motor_mode: FL_1 in mode 0x08");
  report.imu.gyroscope = {0.0F, 0.1F, 0.0F};
  expect("gyroscope: 0.100 rad/s");
  report.imu.accelerometer = {0.0F, 0.0F, 9.0F};
  expect("accelerometer");
  report.imu.quaternion = {0.9F, 0.0F, 0.0F, 0.0F};
  expect("quaternion");
  constexpr double kJump = 2.5;  // [s] for which an attitude jump blocks arming
  report.imu.quaternion = {0.0F, 0.0F, 0.4794F, 0.8776F};  // 1 rad of yaw in the order x y z w
  expect("attitude: the quaternion leans 57.3 deg off the vertical", kJump);
  const auto lean = [&](float felt, float said) {  // [rad] of pitch
    report.imu.accelerometer = {-9.81F * std::sin(felt), 0.0F, 9.81F * std::cos(felt)};
    report.imu.quaternion = {std::cos(0.5F * said), 0.0F, std::sin(0.5F * said), 0.0F};
  };
  lean(0.1F, -0.1F);  // inverted: world to IMU
  expect("attitude: the quaternion leans 11.5 deg off the vertical", kJump);
  lean(0.1F, -0.06F);
  run(kJump);
  BOOST_TEST(failures() == "");
  lean(0.0F, 0.0F);
  run(kJump);
  std::swap(report.motorState[FR_1].q, report.motorState[FR_2].q);
  expect("motor_order: FR_1 and FR_2 seem swapped");
  const auto stop = static_cast<float>(quadruped().config().q_lower[FR_2]);
  report.motorState[FR_2].q = report.motorState[FR_1].q;
  report.motorState[FR_1].q = stop - 0.1F;  // a knee at its mechanical stop
  expect("motor_order: FR_1 and FR_2 seem swapped");
  report.motorState[FR_2].q = 0.8F;
  const auto end = static_cast<float>(quadruped().config().q_lower[FR_1]);
  // A little outside its own range, and inside that of FR_2.
  report.motorState[FR_1].q = end - 0.17F;
  expect("motor_order: FR_1 and FR_2 seem swapped");
  report.imu.accelerometer = {6.0F, 0.0F, 7.8F};
  expect("tilt");
}

BOOST_AUTO_TEST_CASE(zero_arming_time_still_requires_passed_checks) {
  SupervisorOptions options;
  options.arming_time = 0.0;
  RestingRobot lies(options);
  lies.report.motorState[RR_2].temperature = 71;
  lies.run(0.1);
  BOOST_TEST(!lies.supervisor.arming().ready);
  BOOST_TEST((lies.supervisor.arm() == RequestStatus::kNotReady));
  lies.report.motorState[RR_2].temperature = 30;
  lies.run(1.0);
  BOOST_TEST((lies.supervisor.arm() == RequestStatus::kAccepted));
}

BOOST_FIXTURE_TEST_CASE(fast_clock_fault_does_not_block_the_next_rise, RestingRobot) {
  run(0.1);
  const LowState rest = report;
  for (int k = 0; k <= 628; ++k) {  // the legs are moved, and every 2 ms count as 4 ms
    const double phase = 0.01 * k;
    for (int i = 0; i < kMotors; ++i) {
      report.motorState[i].q = rest.motorState[i].q + float(0.2 * (1.0 - std::cos(phase)));
      report.motorState[i].dq = float(0.2 * std::sin(phase) * 0.01 / 0.002);
    }
    report.tick += 4;
    last = supervisor.update(report);
  }
  BOOST_TEST(supervisor.faults().has(FaultId::kClock));
  const std::uint32_t tick = report.tick;
  report = rest;
  report.tick = tick;
  run(6.0);
  BOOST_TEST((supervisor.arm() == RequestStatus::kAccepted), failures());
  run(0.01);
  BOOST_TEST((supervisor.request(Mode::kRise) == RequestStatus::kAccepted));
  run(0.1);
  BOOST_TEST((supervisor.mode() == Mode::kRise), to_string(supervisor.damping_fault()));
}

BOOST_FIXTURE_TEST_CASE(link_with_sample_loss_is_not_armed, RestingRobot) {
  run(1.5);
  BOOST_TEST(supervisor.arming().ready);
  for (int i = 0; i < 20; ++i) {
    run(0.06);
    report.tick += 4;
  }
  run(0.002);
  BOOST_TEST(failures().find("link") != std::string::npos);
}

BOOST_FIXTURE_TEST_CASE(nan_in_a_sample_does_not_affect_later_samples, RestingRobot) {
  run(1.2);
  report.imu.accelerometer = {NAN, 0.0F, 9.81F};
  run(0.1);
  BOOST_TEST(motors_brake(last));
  BOOST_TEST(!supervisor.arming().ready);
  report.imu.accelerometer = {0.0F, 0.0F, 9.81F};
  run(1.2);
  BOOST_TEST(supervisor.arming().ready);
}

BOOST_FIXTURE_TEST_CASE(rise_without_leg_motion_is_reported_as_wrong_robot, RestingRobot) {
  run(1.1);
  supervisor.arm();
  run(0.002);
  BOOST_TEST((supervisor.request(Mode::kRise) == RequestStatus::kAccepted));
  run(0.002);
  BOOST_TEST((supervisor.mode() == Mode::kRise));
  run(6.0);
  BOOST_TEST((supervisor.mode() == Mode::kDamping));
  BOOST_TEST((supervisor.damping_fault() == FaultId::kWrongRobot));
  BOOST_TEST(motors_brake(last));
}

BOOST_FIXTURE_TEST_CASE(rise_with_stuck_legs_gives_up_and_damps, RestingRobot) {
  run(1.1);
  supervisor.arm();
  run(0.002);
  BOOST_TEST((supervisor.request(Mode::kRise) == RequestStatus::kAccepted));
  move_hip();
  run(12.0);
  BOOST_TEST((supervisor.mode() == Mode::kRise));  // it retries
  run(30.0);
  BOOST_TEST((supervisor.mode() == Mode::kPassive));
  BOOST_TEST(supervisor.rise_failed());
  BOOST_TEST(motors_brake(last));
}

BOOST_FIXTURE_TEST_CASE(continued_rolling_is_reported_as_wiring_fault, RestingRobot) {
  run(1.1);
  supervisor.arm();
  step();
  BOOST_TEST((supervisor.request(Mode::kRise) == RequestStatus::kAccepted));
  move_hip();
  roll(0.6F);
  run(0.1);
  BOOST_TEST((supervisor.mode() == Mode::kRise));  // released: the body may still fall back
  roll(0.17F);
  BOOST_TEST((supervisor.mode() == Mode::kDamping));
  BOOST_TEST((supervisor.damping_fault() == FaultId::kWiring));
  BOOST_TEST(motors_brake(last));
}

// The springs of the rise fade out. A fault meanwhile damps at once.
BOOST_FIXTURE_TEST_CASE(fault_during_spring_fade_out_damps_at_once, RestingRobot) {
  run(1.1);
  supervisor.arm();
  step();
  supervisor.request(Mode::kRise);
  move_hip();
  supervisor.request(Mode::kSit);
  step();
  BOOST_TEST((supervisor.mode() == Mode::kPassive));
  BOOST_TEST(!motors_brake(last));
  report.motorState[5].mode = 0;
  run(0.01);
  BOOST_TEST((supervisor.mode() == Mode::kDamping));
  BOOST_TEST((supervisor.damping_fault() == FaultId::kMotorMode));
  BOOST_TEST(motors_brake(last));
}

BOOST_FIXTURE_TEST_CASE(standing_robot_rises_without_folding, RestingRobot) {
  turn_hips(-0.5F);
  run(1.1);
  supervisor.arm();
  step();
  BOOST_TEST((supervisor.request(Mode::kRise) == RequestStatus::kAccepted));
  step();
  BOOST_TEST((supervisor.mode() == Mode::kRise));
  BOOST_TEST(supervisor.rise_progress() == 1.0);
  run(1.1);
  BOOST_TEST((supervisor.mode() == Mode::kStand));
}

BOOST_FIXTURE_TEST_CASE(repeated_samples_damp_within_20_ms, RestingRobot) {
  run(1.1);
  supervisor.arm();
  run(0.002);
  supervisor.request(Mode::kRise);
  run(0.5);
  BOOST_TEST(!motors_brake(last));
  for (int i = 0; i < 10; ++i) last = supervisor.update(report);
  BOOST_TEST(motors_brake(last));
  BOOST_TEST((supervisor.mode() == Mode::kDamping));
  BOOST_TEST((supervisor.damping_fault() == FaultId::kStaleTick));
}

BOOST_FIXTURE_TEST_CASE(each_sample_fault_is_detected_within_its_time, RestingRobot) {
  const auto expect = [&](FaultId id, auto&& inject_fault) {
    run(1.2);
    BOOST_TEST((supervisor.arm() == RequestStatus::kAccepted));
    step();
    BOOST_TEST((supervisor.request(Mode::kRise) == RequestStatus::kAccepted));
    run(0.5);
    BOOST_TEST((supervisor.mode() == Mode::kRise));
    const LowState good = report;
    int ticks = 0;
    for (; ticks < 100 && supervisor.mode() != Mode::kDamping; ++ticks) {
      report.tick += 2;
      report.imu.gyroscope[2] = -report.imu.gyroscope[2];
      report.motorState[3].dq = -report.motorState[3].dq;
      for (int i = 0; i < kMotors; ++i) report.motorState[i].tauEst = last.motorCmd[i].tau;
      inject_fault(report, good);
      last = supervisor.update(report);
    }
    BOOST_TEST(motors_brake(last));
    BOOST_TEST((supervisor.damping_fault() == id), to_string(supervisor.damping_fault())
                                                       << " for " << to_string(id));
    BOOST_TEST(0.002 * ticks <= fault_info(id).detection_time + 1e-9, to_string(id)
                                                                          << ": " << ticks);
    const std::uint32_t tick = report.tick;
    report = good;
    report.tick = tick;
  };
  expect(FaultId::kStateNotFinite, [](LowState& r, const LowState&) { r.imu.gyroscope[1] = NAN; });
  expect(FaultId::kStateImplausible, [](LowState& r, const LowState&) { r.motorState[4].q = 50; });
  expect(FaultId::kStaleTick, [](LowState& r, const LowState& good) { r.tick = good.tick; });
  expect(FaultId::kFrozen, [](LowState& r, const LowState& good) {
    const std::uint32_t tick = r.tick;
    r = good;
    r.tick = tick;
  });
  expect(FaultId::kAttitude,
         [](LowState& r, const LowState&) { r.imu.quaternion = {0.966F, 0.259F, 0.0F, 0.0F}; });
  expect(FaultId::kMotorMode, [](LowState& r, const LowState&) { r.motorState[7].mode = 0x08; });
  expect(FaultId::kMotorWeak, [](LowState& r, const LowState&) { r.motorState[2].tauEst = 20.0F; });
  expect(FaultId::kOverridden, [](LowState& r, const LowState&) {
    r.motorState[2].tauEst = r.motorState[8].tauEst = 20.0F;
  });
  expect(FaultId::kOverridden, [](LowState& r, const LowState&) {
    for (const int i : {2, 8}) r.motorState[i].tauEst += r.tick % 4 == 0 ? 2.0F : -2.0F;
  });
  expect(FaultId::kEncoder, [](LowState& r, const LowState&) { r.motorState[1].dq = 0.3F; });
  expect(FaultId::kJointJump, [](LowState& r, const LowState&) { r.motorState[1].q = -2.0F; });
  expect(FaultId::kPower, [](LowState& r, const LowState&) {
    r.motorState[0].q += r.tick % 4 == 0 ? 1e-4F : -1e-4F;
    r.motorState[0].dq = 15.0F;
    r.motorState[0].tauEst = 8.0F;
  });
  int reports = 0;
  // An impact, whose gyroscope values are rejected at first.
  expect(FaultId::kPower, [&](LowState& r, const LowState&) {
    r.imu.gyroscope[0] = std::min(4.0F * float(++reports), 12.0F);
    r.motorState[0].q += r.tick % 4 == 0 ? 1e-4F : -1e-4F;
    r.motorState[0].dq = 15.0F;
    r.motorState[0].tauEst = 8.0F;
  });
}

// The command hold bridges bad samples for 10 ms, while the joints move on.
BOOST_FIXTURE_TEST_CASE(joint_motion_during_bad_samples_is_not_a_joint_jump, RestingRobot) {
  run(0.1);
  const float speed = 18.0F;  // [rad/s]
  for (int k = 0; k < 20; ++k) {
    report.tick += 2;
    report.motorState[4].dq = speed;
    report.motorState[4].q += 0.002F * speed;
    report.imu.gyroscope[2] = -report.imu.gyroscope[2];
    report.imu.accelerometer[0] = k >= 5 && k < 9 ? NAN : 0.0F;
    supervisor.update(report);
    BOOST_REQUIRE(!supervisor.faults().has(FaultId::kJointJump));
  }
}

BOOST_FIXTURE_TEST_CASE(temperature_and_battery_faults_sit_the_robot_down, RestingRobot) {
  const auto expect = [&](FaultId id, auto&& inject_fault) {
    const LowState good = report;
    run(1.2);
    supervisor.arm();
    step();
    BOOST_TEST((supervisor.request(Mode::kRise) == RequestStatus::kAccepted));
    move_hip();
    inject_fault(report);
    for (int i = 0; i < 1500 && supervisor.mode() == Mode::kRise; ++i) step();
    run(0.1);
    BOOST_TEST((supervisor.mode() == Mode::kSit || supervisor.mode() == Mode::kPassive));
    BOOST_TEST(supervisor.faults().has(id), to_string(id));
    run(6.0);
    BOOST_TEST((supervisor.mode() == Mode::kPassive));
    BOOST_TEST((supervisor.request(Mode::kRise) == RequestStatus::kNotReady));
    const std::uint32_t tick = report.tick;
    report = good;
    report.tick = tick;
    run(6.0);
    BOOST_TEST(!supervisor.faults().has(id), to_string(id));
  };
  expect(FaultId::kTemperature, [](LowState& r) { r.motorState[5].temperature = 90; });
  expect(FaultId::kBattery, [](LowState& r) {
    r.bms.version_h = 1;
    r.bms.SOC = 4;
  });
}

// Two monitors check the IMU; a fault that both detect is counted once.
BOOST_FIXTURE_TEST_CASE(lasting_fault_is_counted_once, RestingRobot) {
  run(1.2);
  const auto stuck = report.imu.gyroscope;
  for (int k = 0; k < 500; ++k) {
    report.tick += 2;
    report.imu.accelerometer[1] = k % 2 == 0 ? 1e-5F : -1e-5F;
    report.imu.gyroscope = stuck;
    supervisor.update(report);
  }
  BOOST_TEST(supervisor.faults().has(FaultId::kGyroscope));
  BOOST_TEST(supervisor.faults().count[static_cast<int>(FaultId::kGyroscope)] == 1);
}

BOOST_FIXTURE_TEST_CASE(frozen_sensors_are_reported_while_lying, RestingRobot) {
  run(1.2);
  for (int k = 0; k < 20; ++k) {
    report.tick += 2;
    supervisor.update(report);
  }
  BOOST_TEST(supervisor.faults().has(FaultId::kFrozen));
  BOOST_TEST((supervisor.arm() == RequestStatus::kNotReady));
  BOOST_TEST(failures() == "fault: frozen keeps the robot down, expected no such fault");
  run(1.2);
  BOOST_TEST(!supervisor.faults().has(FaultId::kFrozen));
  BOOST_TEST((supervisor.arm() == RequestStatus::kAccepted));
}

BOOST_FIXTURE_TEST_CASE(arming_is_refused_while_a_stop_is_pending, RestingRobot) {
  run(1.2);
  supervisor.stop();
  BOOST_TEST((supervisor.arm() == RequestStatus::kBusy));
  run(1.2);
  BOOST_TEST((supervisor.arm() == RequestStatus::kAccepted));
  step();
  WirelessRemote remote;
  remote.buttons = static_cast<std::uint16_t>(Button::kB);
  report.wirelessRemote = encode_wireless_remote(remote);
  run(1.2);
  BOOST_TEST((supervisor.mode() == Mode::kDamping));
  BOOST_TEST((supervisor.arm() == RequestStatus::kNotReady));
  BOOST_TEST(failures() == "fault: button keeps the robot down, expected no such fault");
}

BOOST_AUTO_TEST_CASE(rise_plan_is_slower_at_lower_power) {
  const Robot robot = quadruped();
  const RisePlan fast = plan_rise(robot, 1000.0), slow = plan_rise(robot, 5.0);
  BOOST_TEST(slow.time > 2.0 * fast.time);
  BOOST_TEST(fast.max_holding_share < 1.0);
  for (int i = 0; i < kMotors; ++i) {
    BOOST_TEST(fast.folded[i] > robot.config().q_lower[i]);
    BOOST_TEST(fast.folded[i] < robot.config().q_upper[i]);
  }
  const FeetMatrix feet = [&] {
    Eigen::VectorXd q = robot.q_standing();
    for (int i = 0; i < kMotors; ++i) q[robot.motor_to_q()[i]] = fast.folded[i];
    return contact_points(robot, q);
  }();
  for (int leg = 0; leg < kLegs; ++leg) BOOST_TEST(feet(2, leg) > -0.15);
}

BOOST_AUTO_TEST_CASE(reversed_height_motion_is_continuous) {
  const RisePlan plan = plan_rise(quadruped(), 50.0);
  RiseMotion motion(plan);
  motion.start(0.0, plan.folded);
  motion.go_to(1.0);
  JointReference before{plan.folded, Vector12::Zero()};
  bool arrived = false;
  for (int i = 0; i < 5000 && !arrived; ++i) {
    if (i == 400) motion.go_to(0.0);
    const JointReference now = motion.step(before.q, 0.002);
    BOOST_TEST((now.dq - before.dq).cwiseAbs().maxCoeff() < 0.03);
    before = now;
    arrived = i > 400 && motion.arrived();
  }
  BOOST_TEST(arrived);
  BOOST_TEST((before.q - plan.folded).norm() < 1e-9);
}

BOOST_AUTO_TEST_CASE(published_values_are_read_consistently) {
  struct Pair {
    std::array<long, 20> values{};
  };
  Seqlock<Pair> published;
  constexpr int kReads = 20000;  // while the writer runs
  std::atomic<int> reads{0};
  std::atomic<bool> over{false};
  std::thread writer([&] {
    for (long k = 0; k < 200000 || reads < kReads; ++k) {
      Pair pair;
      pair.values.fill(k);
      published.write(pair);
    }
    over = true;
  });
  bool whole = true;
  while (!over) {
    const Pair pair = published.read();
    ++reads;
    for (const long value : pair.values) whole = whole && value == pair.values[0];
  }
  writer.join();
  BOOST_TEST(whole);
}

BOOST_AUTO_TEST_CASE(out_of_range_option_error_names_the_option) {
  SupervisorOptions options;
  options.power_level = 11;
  BOOST_CHECK_EXCEPTION(Supervisor(quadruped(), Gains{}, options), Error, [](const Error& e) {
    return std::string(e.what()).find("power_level") != std::string::npos;
  });
}

BOOST_AUTO_TEST_SUITE_END()
