// SPDX-License-Identifier: BSD-3-Clause
// What a long rest does to the estimate.
#include <boost/test/unit_test.hpp>
#include <random>

#include "scenes.hpp"
#include "surefoot/state_estimator.hpp"

using namespace surefoot;

namespace {

// A resting robot's reports, all of it trembling but the joints' angles. The velocities' noise
// is twenty times that of a real driver, so that what grows with its square shows within four
// minutes.
class Trembling {
 public:
  explicit Trembling(const Robot& robot) : rest_(resting_report(robot, 0)) {}

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

// Contact points that were rolled by these velocities made tilt and bias walk together, always the
// same way: 0.9 deg and 0.15 m/s^2 here, and 2.4 deg of yaw.
BOOST_AUTO_TEST_CASE(trembling_joint_velocities_do_not_turn_the_world) {
  const Robot robot = quadruped();
  StateEstimator estimator(robot);
  Trembling trembling(robot);
  for (std::uint32_t tick = 0; tick < 120000; ++tick) {
    const Status status = estimator.update(trembling.report(2 * tick), 0.002);
    BOOST_TEST_REQUIRE((status == Status::kOk));
  }
  const Eigen::Vector4d turned = estimator.state().q.segment<4>(3);
  BOOST_TEST(2.0 * turned.head<2>().norm() < 5e-3);
  BOOST_TEST(2.0 * std::abs(turned.z()) < 5e-3);
  BOOST_TEST(estimator.report().accelerometer_bias.norm() < 0.05);
}

BOOST_AUTO_TEST_SUITE_END()
