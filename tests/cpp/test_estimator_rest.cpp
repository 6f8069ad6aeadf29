// SPDX-License-Identifier: BSD-3-Clause
// The state estimate at rest: over four minutes, and after sensor faults.
#include <boost/test/unit_test.hpp>
#include <random>

#include "robot_states.hpp"
#include "surefoot/state_estimator.hpp"

using namespace surefoot;

namespace {

// Samples of a robot at rest with noise on everything except the joint angles. The noise of the
// joint velocities is twenty times that of a real driver, so that errors that grow with its square
// are visible within four minutes.
class NoisyRestingRobot {
 public:
  explicit NoisyRestingRobot(const Robot& robot) : rest_(resting_sample(robot, 0)) {}

  const LowState& report(std::uint32_t tick) {
    report_ = rest_;
    report_.tick = tick;
    for (int k = 0; k < 3; ++k) {
      report_.imu.gyroscope[k] += noise(0.005F);
      report_.imu.accelerometer[k] += noise(0.05F);
    }
    for (int i = 0; i < kMotors; ++i) report_.motorState[i].dq = noise(1.0F);
    return report_;
  }

 private:
  float noise(float sigma) { return sigma * normal_(generator_); }
  LowState rest_, report_;
  std::mt19937 generator_{7};
  std::normal_distribution<float> normal_;
};

}  // namespace

BOOST_AUTO_TEST_SUITE(estimator_rest)

// If the filter rolled the contact points with these noisy velocities, tilt, yaw and accelerometer
// bias would drift steadily.
BOOST_AUTO_TEST_CASE(noisy_joint_velocities_do_not_rotate_the_estimate) {
  const Robot robot = quadruped();
  StateEstimator estimator(robot);
  NoisyRestingRobot noisy_robot(robot);
  for (std::uint32_t tick = 0; tick < 120000; ++tick) {
    const Status status = estimator.update(noisy_robot.report(2 * tick), 0.002);
    BOOST_TEST_REQUIRE((status == Status::kOk));
  }
  const Eigen::Vector4d turned = estimator.state().q.segment<4>(3);
  BOOST_TEST(2.0 * turned.head<2>().norm() < 5e-3);
  BOOST_TEST(2.0 * std::abs(turned.z()) < 5e-3);
  BOOST_TEST(estimator.report().accelerometer_bias.norm() < 0.05);
}

// The gyroscope is wrong while no quaternion is available: the tilt is wrong, with a small
// covariance.
BOOST_AUTO_TEST_CASE(filter_recovers_from_a_wrong_gyroscope) {
  const Robot robot = quadruped();
  StateEstimator estimator(robot);
  NoisyRestingRobot noisy_robot(robot);
  std::uint32_t tick = 0;
  double max_tilt = 0.0;
  const auto run = [&](double seconds, bool faulty) {
    for (int k = 0; k < static_cast<int>(500.0 * seconds); ++k, tick += 2) {
      LowState report = noisy_robot.report(tick);
      if (faulty) {
        report.imu.gyroscope[0] += 20.0F;
        report.imu.quaternion = {};
      }
      estimator.update(report, 0.002);
      const Eigen::Vector4d q = estimator.state().q.segment<4>(3);
      if (faulty) max_tilt = std::max(max_tilt, 2.0 * q.head<2>().norm());
    }
  };
  run(2.0, false);
  run(0.05, true);
  BOOST_TEST(max_tilt > 0.2);
  run(5.0, false);
  BOOST_TEST(2.0 * estimator.state().q.segment<2>(3).norm() < 0.02);
  BOOST_TEST(estimator.report().accelerometer_bias.norm() < 0.2);
  BOOST_TEST(estimator.state().contact.minCoeff() > 0.9);
}

// Each value is within the range of its sensor, but no motion explains them together.
BOOST_AUTO_TEST_CASE(diverged_estimate_is_reset) {
  const Robot robot = quadruped();
  StateEstimator estimator(robot);
  NoisyRestingRobot noisy_robot(robot);
  std::mt19937 generator(3);
  std::uniform_real_distribution<float> any(-1.0F, 1.0F);
  int divergences = 0;
  for (std::uint32_t tick = 0; tick < 2000; ++tick) {
    LowState report = noisy_robot.report(2 * tick);
    for (int k = 0; k < 3; ++k) {
      report.imu.gyroscope[k] = 30.0F * any(generator);
      report.imu.accelerometer[k] = 150.0F * any(generator);
    }
    for (int i = 0; i < kMotors; ++i) report.motorState[i].q += 0.3F * any(generator);
    divergences += estimator.update(report, 0.1) == Status::kDiverged;
    BOOST_TEST_REQUIRE(estimator.state().v.norm() < 1e4);
  }
  BOOST_TEST(divergences > 0);
  for (std::uint32_t tick = 2000; tick < 7000; ++tick) {
    estimator.update(noisy_robot.report(2 * tick), 0.002);
  }
  BOOST_TEST(estimator.state().v.head<3>().norm() < 0.1);
  BOOST_TEST(estimator.state().contact.minCoeff() > 0.9);
}

BOOST_AUTO_TEST_SUITE_END()
