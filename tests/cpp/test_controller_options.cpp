// SPDX-License-Identifier: BSD-3-Clause
// Options and body references of a StandController.
#include <boost/test/unit_test.hpp>

#include "robot_states.hpp"
#include "surefoot/error.hpp"
#include "surefoot/stand_controller.hpp"
#include "tick/controller_access.hpp"

using namespace surefoot;

namespace {

// Sample of a standing robot with a small oscillation on its sensors.
LowState disturbed_sample(const Robot& robot, std::uint32_t tick) {
  LowState report = resting_sample(robot, tick);
  const float wave = std::sin(0.03F * static_cast<float>(tick));
  report.imu.gyroscope = {0.2F * wave, -0.1F * wave, 0.1F * wave};
  report.imu.accelerometer[1] = 0.5F * wave;
  for (int i = 0; i < kMotors; ++i) {
    report.motorState[i].q += 0.005F * wave;
    report.motorState[i].dq = 0.3F * wave * (i % 2 ? 1.0F : -1.0F);
    report.motorState[i].tauEst += 0.01F * wave;  // the estimator ignores constant torques
  }
  return report;
}

double largest_difference(const LowCmd& a, const LowCmd& b) {
  double worst = 0.0;
  for (int i = 0; i < kMotors; ++i) {
    const float one = a.motorCmd[i].tau, other = b.motorCmd[i].tau;
    worst = std::max(worst, static_cast<double>(std::abs(one - other)));
  }
  return worst;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(controller_options)

BOOST_AUTO_TEST_CASE(motor_damping_is_added_only_when_requested) {
  const Robot robot = quadruped();
  ControllerOptions options;
  options.motor_damping = 0.5;
  StandController controller(robot, Gains(), options);
  const LowCmd command = controller.update(resting_sample(robot, 0));
  BOOST_TEST(command.motorCmd[3].Kd == 0.5F);
  BOOST_TEST(command.motorCmd[3].dq == 0.0F);
  BOOST_TEST(command.motorCmd[3].Kp == 0.0F);
  options.motor_damping = -1.0;
  BOOST_CHECK_THROW(StandController(robot, Gains(), options), Error);
}

// The estimator's dynamics are in a frame of their own, and both forms have to account for it.
BOOST_AUTO_TEST_CASE(both_forms_send_the_same_torques_to_a_moving_robot) {
  const Robot robot = quadruped();
  ControllerOptions general;
  general.form = QpForm::kGeneral;
  StandController a(robot), b(robot, Gains(), general);
  for (StandController* c : {&a, &b}) ControllerAccess::end_sensor_check(*c);
  for (std::uint32_t tick = 2; tick < 2000; tick += 2) {
    const LowState report = disturbed_sample(robot, tick);
    const LowCmd& one = a.update(report);
    const LowCmd& other = b.update(report);
    BOOST_REQUIRE((is_usable(a.status()) && a.status() == b.status()));
    BOOST_REQUIRE((a.solution().form == QpForm::kCondensed));
    BOOST_REQUIRE((b.solution().form == QpForm::kGeneral));
    BOOST_REQUIRE(largest_difference(one, other) < 0.02);
  }
  BOOST_TEST(a.state().v.norm() > 0.0);
}

BOOST_AUTO_TEST_CASE(delay_option_enables_prediction_and_is_range_checked) {
  const Robot robot = quadruped();
  ControllerOptions delayed_options;
  delayed_options.delay = 0.01;
  StandController direct_controller(robot), delayed_controller(robot, Gains(), delayed_options);
  for (StandController* c : {&direct_controller, &delayed_controller}) {
    ControllerAccess::end_sensor_check(*c);
  }
  double max_difference = 0.0;
  for (std::uint32_t tick = 2; tick < 400; tick += 2) {
    const LowState report = disturbed_sample(robot, tick);
    const LowCmd& one = direct_controller.update(report);
    max_difference =
        std::max(max_difference, largest_difference(one, delayed_controller.update(report)));
    BOOST_REQUIRE(is_usable(delayed_controller.status()));
  }
  BOOST_TEST(max_difference > 0.1);
  StandController resting(robot, Gains(), delayed_options);
  for (std::uint32_t tick = 2; tick < 400; tick += 2) resting.update(resting_sample(robot, tick));
  const LowState report = resting_sample(robot, 400);
  BOOST_TEST(largest_difference(resting.update(report), StandController(robot).update(report)) <
             0.3);
  for (const double delay : {-0.001, 0.051, std::nan("")}) {
    delayed_options.delay = delay;
    BOOST_CHECK_THROW(StandController(robot, Gains(), delayed_options), Error);
  }
}

BOOST_AUTO_TEST_CASE(body_reference_moves_the_body_and_reports_its_limit) {
  const Robot robot = quadruped();
  StandController controller(robot);
  std::uint32_t tick = 0;
  const auto run = [&](int ticks) {
    for (int k = 0; k < ticks; ++k) controller.update(resting_sample(robot, tick += 2));
  };
  run(10);
  const double height = controller.reference().p_com.z();
  controller.set_body_reference({0.0, 0.0, -0.03, 0.0, 0.0, 0.1});
  run(1000);
  BOOST_TEST(std::abs(controller.body_reference().height + 0.03) < 1e-3);
  BOOST_TEST(std::abs(controller.body_reference().yaw - 0.1) < 1e-3);
  BOOST_TEST((controller.reach().limit == ReachLimit::kNone));
  BOOST_TEST(controller.reference().p_com.z() < height - 0.02);
  controller.set_body_reference({0.0, 0.0, -1.0, 0.0, 0.0, 0.0});
  run(1500);
  BOOST_TEST((controller.reach().limit == ReachLimit::kJoint));
  BOOST_TEST(controller.body_reference().height > -0.25);
  controller.set_body_reference({0.0, 0.0, std::nan(""), 0.0, 0.0, 0.0});
  BOOST_TEST((controller.reach().limit == ReachLimit::kNotFinite));
  run(10);
  BOOST_TEST(is_usable(controller.status()));
}

BOOST_AUTO_TEST_SUITE_END()
