// SPDX-License-Identifier: BSD-3-Clause
#include <boost/test/unit_test.hpp>

#include "dynamics/dynamics.hpp"
#include "estimator/attitude.hpp"
#include "estimator/base_filter.hpp"
#include "estimator/contact_estimator.hpp"
#include "scenes.hpp"
#include "surefoot/state_estimator.hpp"

using namespace surefoot;

namespace {

constexpr double kPeriod = 0.002;
constexpr std::array<std::int16_t, 4> kSilent{0, 0, 0, 0};

struct Standing {
  Robot robot = quadruped();
  Gains gains;
  Dynamics dynamics{robot};
  Vector12 tau;
  Standing() {
    dynamics.update(robot.q_standing(), Eigen::VectorXd::Zero(robot.nv()), Vector3::UnitZ());
    const LowState report = resting_report(robot, 0);
    for (int i = 0; i < kMotors; ++i) tau[i] = report.motorState[i].tauEst;
  }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(estimator)

BOOST_AUTO_TEST_CASE(a_turned_imu_mount_is_turned_back) {
  RobotConfig config = quadruped_config();
  const Quaternion mount(Eigen::AngleAxisd(0.7, Vector3(1, 2, -1).normalized()));
  config.quat_base_imu << mount.w(), mount.x(), mount.y(), mount.z();
  const Quaternion base(Eigen::AngleAxisd(0.3, Vector3(0.2, 1, 0.5).normalized()));
  const Vector3 w_base(0.1, -0.2, 0.3);
  const Quaternion imu_world = base * mount;
  const Vector3 w_imu = mount.conjugate() * w_base;
  IMU imu{};
  imu.quaternion = {float(imu_world.w()), float(imu_world.x()), float(imu_world.y()),
                    float(imu_world.z())};
  imu.gyroscope = {float(w_imu.x()), float(w_imu.y()), float(w_imu.z())};
  ImuReading reading;
  BOOST_TEST((read_imu(imu, config, reading) == Status::kOk));
  BOOST_TEST(reading.R_world_base.angularDistance(base) < 1e-6);
  BOOST_TEST((reading.w_base - w_base).norm() < 1e-6);
}

BOOST_AUTO_TEST_CASE(a_quaternion_far_from_unit_length_is_refused) {
  ImuReading reading;
  for (const float scale : {0.0F, 0.9F, 1.1F}) {
    IMU imu{};
    imu.quaternion = {scale, 0.0F, 0.0F, 0.0F};
    BOOST_TEST((read_imu(imu, quadruped_config(), reading) == Status::kBadQuaternion));
  }
}

BOOST_FIXTURE_TEST_CASE(the_legs_tell_the_gyroscopes_bias, Standing) {
  const Vector3 bias(0.02, -0.01, 0.015);
  ImuReading imu;
  imu.f_base = Vector3(0.0, 0.0, kGravity);
  imu.w_base = bias;
  AttitudeFilter filter;
  filter.reset(imu);
  for (int tick = 0; tick < 6000; ++tick) {
    filter.update(gains, imu, 0.0, kPeriod);
    Eigen::VectorXd v = Eigen::VectorXd::Zero(robot.nv());
    v.segment<3>(3) = filter.w_base();
    dynamics.update(robot.q_standing(), v, Vector3::UnitZ());
    filter.learn_bias(gains, dynamics, Eigen::Vector4d::Ones(), kPeriod);
  }
  BOOST_TEST((filter.gyro_bias() - bias).norm() < 1e-4);
  BOOST_TEST(filter.R_world_base().angularDistance(Quaternion::Identity()) < 0.1);
}

BOOST_FIXTURE_TEST_CASE(tilt_comes_back_to_the_accelerometers_plumb_line, Standing) {
  ImuReading imu;
  imu.f_base = Vector3(0.0, 0.0, kGravity);
  imu.R_world_base = Quaternion(Eigen::AngleAxisd(0.1, Vector3::UnitX()));
  AttitudeFilter filter;
  filter.reset(imu);
  for (int tick = 0; tick < 10000; ++tick) filter.update(gains, imu, 0.0, kPeriod);
  const Vector3 up = filter.R_world_base() * Vector3::UnitZ();
  BOOST_TEST(up.z() > std::cos(2e-3));
}

BOOST_FIXTURE_TEST_CASE(torques_alone_tell_which_feet_carry_and_how_much, Standing) {
  ContactEstimator contact(robot.mass() * kGravity);
  for (int tick = 0; tick < 100; ++tick) {
    contact.update(gains, dynamics, tau, kSilent, Vector3::UnitZ(), kPeriod);
  }
  const Eigen::Vector4d even = Eigen::Vector4d::Constant(robot.mass() * kGravity / 4.0);
  BOOST_TEST((contact.torque_force() - even).cwiseAbs().maxCoeff() < 0.01);
  BOOST_TEST((contact.probability() == Eigen::Vector4d::Ones()));
  BOOST_TEST(!contact.foot_force_alive());
}

BOOST_FIXTURE_TEST_CASE(a_lifted_foot_is_lost_within_the_dwell_and_found_again, Standing) {
  ContactEstimator contact(robot.mass() * kGravity);
  std::array<std::int16_t, 4> force{30, 30, 30, 30};
  for (int tick = 0; tick < 100; ++tick) {
    contact.update(gains, dynamics, tau, force, Vector3::UnitZ(), kPeriod);
  }
  force[FL_] = 1;
  for (int tick = 0; tick < 11; ++tick) {
    contact.update(gains, dynamics, tau, force, Vector3::UnitZ(), kPeriod);
  }
  BOOST_TEST(contact.probability()[FL_] == 0.0);
  BOOST_TEST(contact.probability()[FR_] == 1.0);
  const double between = 0.5 * (gains.contact_force_on + gains.contact_force_off);
  force[FL_] = static_cast<std::int16_t>(between * robot.mass() * kGravity);  // stays lost
  contact.update(gains, dynamics, tau, force, Vector3::UnitZ(), kPeriod);
  BOOST_TEST(contact.probability()[FL_] == 0.0);
  force[FL_] = 30;
  for (int tick = 0; tick < 11; ++tick) {
    contact.update(gains, dynamics, tau, force, Vector3::UnitZ(), kPeriod);
  }
  BOOST_TEST(contact.probability()[FL_] == 1.0);
}

BOOST_FIXTURE_TEST_CASE(a_force_field_that_goes_silent_while_the_legs_carry_is_dead, Standing) {
  ContactEstimator contact(robot.mass() * kGravity);
  for (int tick = 0; tick < 100; ++tick) {
    contact.update(gains, dynamics, tau, {30, 30, 30, 30}, Vector3::UnitZ(), kPeriod);
  }
  BOOST_TEST(contact.foot_force_alive());
  for (int tick = 0; tick < 100; ++tick) {
    contact.update(gains, dynamics, tau, kSilent, Vector3::UnitZ(), kPeriod);
  }
  BOOST_TEST(!contact.foot_force_alive());
  BOOST_TEST((contact.probability() == Eigen::Vector4d::Ones()));
}

BOOST_FIXTURE_TEST_CASE(stray_counts_in_a_dead_force_field_change_nothing, Standing) {
  ContactEstimator contact(robot.mass() * kGravity);
  for (int tick = 0; tick < 1000; ++tick) {
    const auto stray = static_cast<std::int16_t>(tick % 7 == 0 ? 1 : 3);
    contact.update(gains, dynamics, tau, {stray, 0, 2, stray}, Vector3::UnitZ(), kPeriod);
    BOOST_TEST(!contact.foot_force_alive());
  }
  BOOST_TEST((contact.probability() == Eigen::Vector4d::Ones()));
}

BOOST_FIXTURE_TEST_CASE(velocity_is_found_from_a_wrong_start_and_an_accelerometer_bias, Standing) {
  BaseFilter filter;
  FeetMatrix feet;
  for (int leg = 0; leg < kLegs; ++leg) feet.col(leg) = dynamics.legs()[leg].p_world_contact;
  filter.reset(Vector3::Zero(), feet);
  const Vector3 f_world(0.05, -0.05, kGravity + 0.05);
  for (int tick = 0; tick < 1000; ++tick) {
    filter.update(gains, f_world, Vector3::Zero(), Vector3::Zero(), dynamics,
                  Eigen::Vector4d::Ones(), kPeriod);
  }
  BOOST_TEST(filter.v_imu().norm() < 0.02);
  BOOST_TEST(filter.refused() == 0);
  BOOST_TEST(filter.covariance().isApprox(filter.covariance().transpose(), 1e-9));
  BOOST_TEST(filter.covariance().diagonal().minCoeff() >= 0.0);
}

BOOST_FIXTURE_TEST_CASE(one_foot_that_lies_about_its_speed_is_refused, Standing) {
  BaseFilter filter;
  FeetMatrix feet;
  for (int leg = 0; leg < kLegs; ++leg) feet.col(leg) = dynamics.legs()[leg].p_world_contact;
  filter.reset(Vector3::Zero(), feet);
  const Vector3 f_world(0.0, 0.0, kGravity);
  for (int tick = 0; tick < 200; ++tick) {
    filter.update(gains, f_world, Vector3::Zero(), Vector3::Zero(), dynamics,
                  Eigen::Vector4d::Ones(), kPeriod);
  }
  Eigen::VectorXd v = Eigen::VectorXd::Zero(robot.nv());
  v[robot.motor_to_v()[RL_1]] = 5.0;
  dynamics.update(robot.q_standing(), v, Vector3::UnitZ());
  for (int tick = 0; tick < 100; ++tick) {
    filter.update(gains, f_world, Vector3::Zero(), Vector3::Zero(), dynamics,
                  Eigen::Vector4d::Ones(), kPeriod);
    BOOST_TEST(filter.refused() == 1);
  }
  BOOST_TEST(filter.v_imu().norm() < 0.02);
}

BOOST_AUTO_TEST_CASE(a_resting_robot_is_at_rest_with_its_feet_at_height_zero) {
  const Robot robot = quadruped();
  StateEstimator estimator(robot);
  for (std::uint32_t tick = 0; tick < 1000; ++tick) {
    BOOST_TEST((estimator.update(resting_report(robot, 2 * tick), kPeriod) == Status::kOk));
  }
  BOOST_TEST(estimator.state().v.norm() < 1e-3);
  for (const LegDynamics& leg : estimator.dynamics().legs()) {
    BOOST_TEST(std::abs(leg.p_world_contact.z()) < 1e-4);
  }
}

BOOST_AUTO_TEST_SUITE_END()
