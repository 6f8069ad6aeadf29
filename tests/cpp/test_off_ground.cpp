// SPDX-License-Identifier: BSD-3-Clause
// The estimate of a robot that does not stand: a hand moves it, and its legs are still.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <functional>

#include "robot_states.hpp"
#include "surefoot/state_estimator.hpp"

using namespace surefoot;

namespace {

constexpr double kPeriod = 0.002;

// A robot with an ideal IMU that a hand moves. No sensor measures its feet.
class HandMovedRobot {
 public:
  explicit HandMovedRobot(bool has_torques = false) : has_torques_(has_torques) {
    sample_.imu.quaternion = {};
    sample_.footForce = sample_.footForceEst = {};
    if (has_torques) return;
    for (int i = 0; i < kMotors; ++i) sample_.motorState[i].tauEst = 0.0F;
  }

  // Move for a time [s]; `rate` [rad/s], base axes, and `acceleration` [m/s^2], world axes, of the
  // time since the start of this call. The gyroscope measures `scale` times the rate.
  void move(double duration, const std::function<Vector3(double)>& rate,
            const std::function<Vector3(double)>& acceleration, double scale = 1.0) {
    double squares = 0.0;
    const int ticks = static_cast<int>(duration / kPeriod);
    for (int k = 0; k < ticks; ++k) {
      const double time = kPeriod * k;
      const Vector3 w = rate(time);
      R_ = (R_ * exp_so3(kPeriod * rate(time - 0.5 * kPeriod))).normalized();
      const Vector3 f = R_.conjugate() * (acceleration(time) + kGravity * Vector3::UnitZ());
      sample_.tick += 2;
      for (int i = 0; i < 3; ++i) {
        sample_.imu.gyroscope[i] = static_cast<float>(scale * w[i]);
        // Values that never change count as broken, and torques of zero as missing.
        if (has_torques_) sample_.motorState[0].tauEst += k % 2 == 0 ? 1e-3F : -1e-3F;
        sample_.imu.accelerometer[i] = static_cast<float>(f[i] + (k % 2 == 0 ? 1e-3 : -1e-3));
      }
      BOOST_REQUIRE((estimator.update(sample_, kPeriod) == Status::kOk));
      squares += tilt_error() * tilt_error();
    }
    tilt_rms = std::sqrt(squares / ticks);
  }
  void rest(double duration) { move(duration, still, still); }
  double contact() const { return estimator.state().contact.maxCoeff(); }
  double tilt_error() const {
    const Eigen::Vector4d q = estimator.state().q.segment<4>(3);  // x y z w
    const Vector3 up = Quaternion(q[3], q[0], q[1], q[2]).conjugate() * Vector3::UnitZ();
    return std::acos(std::min(up.dot(R_.conjugate() * Vector3::UnitZ()), 1.0));
  }
  static Vector3 still(double /*time*/) { return Vector3::Zero(); }

  Robot robot = quadruped();
  StateEstimator estimator{robot};
  double tilt_rms = 0.0;  // [rad] of the last move

 private:
  bool has_torques_;
  LowState sample_ = resting_sample(robot, 0);
  Quaternion R_ = Quaternion::Identity();
};

Vector3 slow_turn(double time) { return Vector3(1.0, 0.5, 0.0) * std::sin(2.0 * time); }
Vector3 shake(double time) { return Vector3(1.5, 0.0, 0.0) * std::sin(3.0 * time); }

// A rotation of up to 5 rad/s.
Vector3 fast_turn(double time) {
  return Vector3(3.5 * std::sin(2.1 * time), 3.5 * std::sin(2.9 * time + 1.0), 1.0);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(off_ground)

BOOST_AUTO_TEST_CASE(still_legs_of_a_body_that_turns_do_not_stand_until_it_is_still) {
  HandMovedRobot moved;
  moved.rest(3.0);
  BOOST_TEST(moved.contact() == 1.0);
  moved.move(6.0, slow_turn, HandMovedRobot::still);
  BOOST_TEST(moved.contact() == 0.0);
  BOOST_TEST(moved.tilt_rms < 0.01);
  moved.rest(4.0);
  BOOST_TEST(moved.contact() == 1.0);
}

BOOST_AUTO_TEST_CASE(still_legs_of_a_body_that_gains_speed_do_not_stand) {
  HandMovedRobot moved;
  moved.rest(3.0);
  moved.move(6.0, HandMovedRobot::still, shake);
  BOOST_TEST(moved.contact() == 0.0);
  BOOST_TEST(moved.tilt_rms < 0.01);
}

BOOST_AUTO_TEST_CASE(measured_loads_of_the_feet_are_not_refuted) {
  HandMovedRobot moved(true);
  moved.rest(3.0);
  moved.move(1.0, HandMovedRobot::still, shake);
  BOOST_TEST(moved.contact() == 1.0);
}

// Without the zero velocity and the scale error of the gyroscope, the tilt is wrong by 0.025 rad.
BOOST_AUTO_TEST_CASE(accelerometer_corrects_the_scale_of_the_gyroscope_off_the_ground) {
  HandMovedRobot moved;
  moved.rest(3.0);
  moved.move(30.0, fast_turn, HandMovedRobot::still, 1.005);
  BOOST_TEST(moved.contact() == 0.0);
  BOOST_TEST(moved.tilt_rms < 0.02);
  BOOST_TEST(moved.estimator.report().gyroscope_bias.norm() < 0.005);
}

BOOST_AUTO_TEST_SUITE_END()
