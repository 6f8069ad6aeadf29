// SPDX-License-Identifier: BSD-3-Clause
#include <boost/test/unit_test.hpp>

#include "quadruped.hpp"
#include "robot_states.hpp"
#include "supervisor/faults/estimator_faults.hpp"
#include "supervisor/faults/imu_monitor.hpp"
#include "supervisor/modes/requests.hpp"
#include "surefoot/error.hpp"
#include "surefoot/supervisor.hpp"

using namespace surefoot;

namespace {

constexpr double kPeriod = 0.002;

// A robot whose motors carry it on four feet, but not on two.
Robot heavy_robot() {
  RobotConfig config = quadruped_config();
  config.tau_max.setConstant(4.0);
  return quadruped(config);
}

/// A supervised robot at rest in its standing pose, taken over standing.
struct StandingRobot {
  Robot robot;
  Supervisor supervisor;
  LowState report = resting_sample(robot, 0);
  LowCmd last = init_low_cmd();
  explicit StandingRobot(const Robot& r = quadruped())
      : robot(r), supervisor(robot, robot.config().gains, options()) {
    for (int i = 0; i < kMotors; ++i) {
      report.motorState[i].mode = kModeServo;
      report.motorState[i].temperature = 30;
    }
    run(0.5);
    BOOST_TEST_REQUIRE((supervisor.mode() == Mode::kStand));
  }
  static SupervisorOptions options() {
    SupervisorOptions out;
    out.start = Start::kStanding;
    return out;
  }
  /// Run ticks. Sensor values change a little, and motors report the commanded torques.
  void run(double seconds) {
    for (int k = 0; k < seconds / kPeriod - 0.5; ++k) {
      report.tick += 2;
      report.imu.gyroscope[2] = report.tick % 4 == 0 ? 1e-5F : -1e-5F;
      report.imu.accelerometer[1] = report.imu.gyroscope[2];
      report.motorState[3].dq = report.tick % 4 == 0 ? 1e-3F : -1e-3F;
      for (int i = 0; i < kMotors; ++i) report.motorState[i].tauEst = last.motorCmd[i].tau;
      last = supervisor.update(report);
    }
  }
  RequestStatus request(Mode mode) {
    const RequestStatus answer = supervisor.request(mode);
    run(kPeriod);
    return answer;
  }
};

RequestContext standing_context() {
  RequestContext context;
  context.mode = Mode::kStand;
  context.state_valid = context.armed = context.ready = true;
  return context;
}

// Return how long no foot may be in contact before the fault lifted [s].
double time_until_lifted(bool stepping) {
  EstimatorFaults faults(1e9);
  FaultLog log;
  const Robot robot = quadruped();
  RobotState state = standing_state(robot);
  state.contact.setZero();
  for (double t = kPeriod; t < 1.0; t += kPeriod) {
    faults.update(EstimatorReport(), state, stepping, kPeriod, log);
    if (log.report().has(FaultId::kLifted)) return t;
  }
  return 1.0;
}

// Return whether the monitor rejects a gyroscope that changes by `change` [rad/s] in one sample.
bool rejects_change(float change, ImuMotion motion) {
  ImuMonitor monitor;
  IMU imu = resting_sample(quadruped(), 0).imu;
  monitor.update(imu, kPeriod, true, motion);
  imu.gyroscope[0] += change;
  monitor.update(imu, kPeriod, true, motion);
  return !monitor.rates_plausible();
}

}  // namespace

BOOST_AUTO_TEST_SUITE(supervisor_walk)

BOOST_AUTO_TEST_CASE(request_to_walk_is_refused_with_its_reason) {
  const auto answer = [](auto change) {
    RequestContext context = standing_context();
    change(context);
    return judge_request(context, Mode::kWalk);
  };
  using Context = RequestContext;
  BOOST_TEST((answer([](Context&) {}) == RequestStatus::kAccepted));
  for (const Mode mode : {Mode::kPassive, Mode::kRise, Mode::kSit, Mode::kWalk}) {
    BOOST_TEST((answer([=](Context& c) { c.mode = mode; }) == RequestStatus::kOutOfOrder));
  }
  BOOST_TEST((answer([](Context& c) { c.mode = Mode::kDamping; }) == RequestStatus::kLatched));
  BOOST_TEST((answer([](Context& c) { c.armed = false; }) == RequestStatus::kNotArmed));
  BOOST_TEST((answer([](Context& c) { c.must_sit = true; }) == RequestStatus::kNotReady));
  BOOST_TEST((answer([](Context& c) { c.must_stand = true; }) == RequestStatus::kNotReady));
  BOOST_TEST((answer([](Context& c) { c.can_walk = false; }) == RequestStatus::kCannotWalk));
  BOOST_TEST((answer([](Context& c) { c.stopping = true; }) == RequestStatus::kBusy));
  BOOST_TEST((answer([](Context& c) { c.fading = true; }) == RequestStatus::kBusy));
}

BOOST_AUTO_TEST_CASE(request_context_survives_its_way_through_the_mailbox) {
  Requests requests;
  for (int flag = 0; flag < 9; ++flag) {
    RequestContext sent;
    sent.mode = Mode::kWalk;
    sent.can_walk = false;
    bool RequestContext::* const flags[] = {
        &RequestContext::state_valid, &RequestContext::armed,    &RequestContext::ready,
        &RequestContext::must_sit,    &RequestContext::fading,   &RequestContext::checks_waived,
        &RequestContext::must_stand,  &RequestContext::can_walk, &RequestContext::stopping};
    sent.*flags[flag] = true;
    requests.publish(sent);
    const RequestContext received = requests.context();
    for (int other = 0; other < 9; ++other) {
      BOOST_TEST((received.*flags[other]) == (other == flag));
    }
    BOOST_TEST((received.mode == Mode::kWalk));
  }
}

BOOST_AUTO_TEST_CASE(walk_ends_when_the_velocity_expires) {
  StandingRobot robot;
  BOOST_TEST((robot.request(Mode::kWalk) == RequestStatus::kAccepted));
  for (int k = 0; k < 400; ++k) {  // 0.8 s, longer than velocity_timeout
    robot.supervisor.set_velocity({});
    robot.run(kPeriod);
    BOOST_REQUIRE((robot.supervisor.mode() == Mode::kWalk));
  }
  robot.run(0.48);
  BOOST_TEST((robot.supervisor.mode() == Mode::kWalk));
  robot.run(0.04);
  BOOST_TEST((robot.supervisor.mode() == Mode::kStand));
}

BOOST_AUTO_TEST_CASE(velocity_has_no_effect_unless_the_mode_is_walk) {
  StandingRobot robot;
  robot.supervisor.set_velocity({0.2, 0.0, 0.0});
  robot.run(0.1);
  BOOST_TEST(!robot.supervisor.controller().walking());
  robot.request(Mode::kWalk);
  robot.supervisor.set_velocity({0.2, 0.0, 0.0});
  robot.run(0.1);
  BOOST_TEST(robot.supervisor.controller().walking());
  BOOST_TEST(robot.supervisor.controller().commanded_velocity().vx == 0.2);
}

BOOST_AUTO_TEST_CASE(robot_that_walks_stops_before_it_sits_down_and_damps_at_once) {
  StandingRobot robot;
  robot.request(Mode::kWalk);
  robot.supervisor.set_velocity({0.3, 0.0, 0.0});
  robot.run(0.3);
  BOOST_TEST_REQUIRE(robot.supervisor.controller().walking());
  BOOST_TEST((robot.request(Mode::kSit) == RequestStatus::kAccepted));
  BOOST_TEST((robot.supervisor.mode() == Mode::kWalk));
  BOOST_TEST(robot.supervisor.stopping());
  robot.supervisor.set_velocity({0.3, 0.0, 0.0});  // ignored
  BOOST_TEST(robot.supervisor.controller().commanded_velocity().vx == 0.0);
  // These samples never move, so the feet step until 1.5 s are over.
  robot.run(1.6);
  BOOST_TEST((robot.supervisor.mode() == Mode::kSit));

  StandingRobot other;
  other.request(Mode::kWalk);
  other.supervisor.set_velocity({0.3, 0.0, 0.0});
  other.run(0.3);
  other.supervisor.stop();
  other.run(kPeriod);
  BOOST_TEST((other.supervisor.mode() == Mode::kDamping));
  BOOST_TEST(motors_brake(other.last));
  BOOST_TEST((other.request(Mode::kWalk) == RequestStatus::kLatched));
}

BOOST_AUTO_TEST_CASE(robot_that_is_too_heavy_to_walk_is_refused_by_name) {
  const Robot robot = heavy_robot();
  BOOST_CHECK_EXCEPTION(WalkController{robot}, Error, [](const Error& error) {
    return std::string(error.what()).find("robot 'testdog' cannot walk: on two feet ") == 0;
  });
  StandingRobot standing(robot);
  BOOST_TEST((standing.request(Mode::kWalk) == RequestStatus::kCannotWalk));
  BOOST_TEST(!standing.supervisor.controller().can_walk());
}

BOOST_AUTO_TEST_CASE(flight_of_a_trot_is_no_lift) {
  BOOST_TEST(time_until_lifted(false) <= fault_info(FaultId::kLifted).detection_time);
  BOOST_TEST(time_until_lifted(true) > 0.15);
  BOOST_TEST(time_until_lifted(true) <= fault_info(FaultId::kLifted).stepping_detection_time);
}

BOOST_AUTO_TEST_CASE(vibration_after_a_touchdown_is_no_gyroscope_jump) {
  BOOST_TEST(rejects_change(4.0F, ImuMotion::kStands));
  BOOST_TEST(!rejects_change(9.0F, ImuMotion::kSteps));
  BOOST_TEST(rejects_change(13.0F, ImuMotion::kSteps));
}

BOOST_AUTO_TEST_CASE(noise_of_a_stepping_gyroscope_is_rejected_and_a_burst_is_not) {
  const auto rejected_after = [](double decay) {  // [s] until a sample is rejected, or 0.1
    ImuMonitor monitor;
    IMU imu = resting_sample(quadruped(), 0).imu;
    monitor.update(imu, kPeriod, true, ImuMotion::kSteps);
    for (int k = 0; k < 50; ++k) {
      imu.gyroscope[0] = static_cast<float>((k % 2 ? -4.0 : 4.0) * std::exp(-k * kPeriod / decay));
      monitor.update(imu, kPeriod, true, ImuMotion::kSteps);
      if (!monitor.rates_plausible()) return k * kPeriod;
    }
    return 0.1;
  };
  BOOST_TEST(rejected_after(0.008) == 0.1);
  BOOST_TEST(rejected_after(10.0) < 0.02);
}

BOOST_AUTO_TEST_SUITE_END()
