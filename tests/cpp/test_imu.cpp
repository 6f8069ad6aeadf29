// SPDX-License-Identifier: BSD-3-Clause
#include <boost/test/unit_test.hpp>
#include <random>

#include "estimator/imu/imu_filter_input.hpp"
#include "estimator/imu/quaternion_tilt_check.hpp"
#include "robot_states.hpp"
#include "surefoot/state_estimator.hpp"

using namespace surefoot;

namespace {

constexpr double kPeriod = 0.002;

std::array<float, 3> to_floats(const Vector3& v) {
  return {float(v.x()), float(v.y()), float(v.z())};
}
std::array<float, 4> to_floats(const Quaternion& q) {
  return {float(q.w()), float(q.x()), float(q.y()), float(q.z())};
}

// An IMU reader and its inputs. Gyroscope, accelerometer and joints can each keep their last value.
struct ImuReaderFixture {
  RobotConfig config = quadruped_config();
  ImuReader reader;
  ImuReading reading;
  IMU imu{};
  Vector12 joints = Vector12::Zero();
  int count = 0;
  ImuReaderFixture() {
    imu.quaternion = {1.0F, 0.0F, 0.0F, 0.0F};
    read(true, true, true);
  }
  void read(bool new_gyroscope, bool new_accelerometer, bool new_joints) {
    const double change = 1e-3 * ++count;
    if (new_gyroscope) imu.gyroscope = to_floats(Vector3(0.1, change, 0.0));
    if (new_accelerometer) imu.accelerometer = to_floats(Vector3(0.0, change, kGravity));
    if (new_joints) joints[4] = change;
    reader.read(imu, config, joints, kPeriod, reading);
  }
};

// A base that turns and translates over standing feet.
struct TurningBase {
  Robot robot = quadruped();
  RobotState state = random_state(robot, 3);
  Dynamics dynamics{robot};
  Vector3 w_base{0.3, -0.5, 0.7};
  InvariantFilter filter;
  Gains gains;
  ImuReading imu;

  // @param w_assumed angular velocity in the dynamics, whose base has no linear velocity, as in the
  // estimator
  explicit TurningBase(const Vector3& w_assumed = Vector3(0.1, 0.2, -0.4)) {
    dynamics.update(state.q, state.v, Vector3::UnitZ());
    Vector6 twist;
    twist << 0.2, -0.1, 0.05, w_base;
    for (int leg = 0; leg < kLegs; ++leg) {
      const LegDynamics& one = dynamics.legs()[leg];
      const Vector3 dq = -one.J_leg.inverse() * (one.J_base * twist);
      for (int k = 0; k < 3; ++k) state.v[robot.motor_to_v()[3 * leg + k]] = dq[k];
    }
    state.v.head<6>() << Vector3::Zero(), w_assumed;
    dynamics.update(state.q, state.v, Vector3::UnitZ());
    filter.reset(Quaternion::Identity(), Vector3::Zero(), Vector3::Zero(), FeetMatrix::Zero(),
                 {0.1, 0.1, 0.01, 0.01, 0.1});
    imu.gyroscope = imu.accelerometer = imu.quaternion = SensorVerdict::kGood;
    imu.has_quaternion = true;
    imu.f_base = Vector3(0.0, 0.0, kGravity);
  }
  ImuInput step(ImuFilterInput& preprocessor, double feet = 1.0, bool stepping = false) {
    return preprocessor.update(gains, imu, filter, dynamics,
                               {Eigen::Vector4d::Constant(feet), stepping, !stepping}, kPeriod);
  }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(imu_input)

BOOST_AUTO_TEST_CASE(rotated_imu_mount_is_compensated) {
  ImuReaderFixture r;
  const Quaternion mount(Eigen::AngleAxisd(0.7, Vector3(1, 2, -1).normalized()));
  r.config.quat_base_imu << mount.w(), mount.x(), mount.y(), mount.z();
  const Quaternion base(Eigen::AngleAxisd(0.3, Vector3(0.2, 1, 0.5).normalized()));
  const Vector3 w_base(0.1, -0.2, 0.3), f_base(0.5, 1.0, 9.0);
  r.imu.quaternion = to_floats(base * mount);
  r.imu.gyroscope = to_floats(mount.conjugate() * w_base);
  r.imu.accelerometer = to_floats(mount.conjugate() * f_base);
  r.read(false, false, true);
  BOOST_TEST(r.reading.R_world_base.angularDistance(base) < 1e-6);
  BOOST_TEST((r.reading.w_base - w_base).norm() < 1e-6);
  BOOST_TEST((r.reading.f_base - f_base).norm() < 1e-5);
}

BOOST_FIXTURE_TEST_CASE(held_values_age_and_repeated_samples_do_not, ImuReaderFixture) {
  BOOST_TEST((reading.w_age == 1 && reading.f_age == 1));
  read(false, true, true);
  BOOST_TEST((reading.w_age == 2 && reading.f_age == 1));
  read(false, false, true);
  BOOST_TEST((reading.w_age == 3 && reading.f_age == 2));
  for (int k = 0; k < 100; ++k) read(false, false, false);
  BOOST_TEST((reading.w_age == 3 && reading.f_age == 2));
  BOOST_TEST((reading.gyroscope == SensorVerdict::kGood));
  read(true, false, true);
  BOOST_TEST((reading.w_age == 1 && reading.f_age == 3));
}

BOOST_FIXTURE_TEST_CASE(sensor_is_constant_after_22_ms_of_joint_motion, ImuReaderFixture) {
  for (int k = 0; k < 10; ++k) {
    read(false, true, true);  // 20 ms: a 50 Hz sensor
    read(false, false, false);
  }
  BOOST_TEST((reading.gyroscope == SensorVerdict::kGood));
  read(false, true, true);
  read(false, true, true);
  BOOST_TEST((reading.gyroscope == SensorVerdict::kConstant));
  BOOST_TEST((reading.accelerometer == SensorVerdict::kGood));
  read(true, false, true);
  BOOST_TEST((reading.gyroscope == SensorVerdict::kGood));
  imu.accelerometer = {};
  for (int k = 0; k < 13; ++k) read(true, false, true);
  BOOST_TEST((reading.accelerometer == SensorVerdict::kZero));
  imu.accelerometer = {0.0F, 0.0F, 9.8F};
  for (int k = 0; k < 13; ++k) read(true, false, true);
  BOOST_TEST((reading.accelerometer == SensorVerdict::kConstant));
}

BOOST_FIXTURE_TEST_CASE(readings_at_the_range_limit_are_saturated, ImuReaderFixture) {
  imu.gyroscope = to_floats(Vector3(0.0, 34.0, 0.0));
  imu.accelerometer = to_floats(Vector3(0.0, 150.0, 0.0));
  read(false, false, true);
  BOOST_TEST(
      (reading.gyroscope == SensorVerdict::kGood && reading.accelerometer == SensorVerdict::kGood));
  imu.gyroscope = to_floats(Vector3(0.0, -34.9, 0.0));
  read(false, false, true);
  BOOST_TEST((reading.gyroscope == SensorVerdict::kSaturated));
  BOOST_TEST((reading.accelerometer == SensorVerdict::kGood));
  imu.accelerometer = to_floats(Vector3(156.9, 0.0, 0.0));
  read(true, false, true);
  BOOST_TEST((reading.gyroscope == SensorVerdict::kGood));
  BOOST_TEST((reading.accelerometer == SensorVerdict::kSaturated));
}

BOOST_FIXTURE_TEST_CASE(invalid_quaternion_is_reported_and_not_used, ImuReaderFixture) {
  const auto verdict = [this](float scale) {
    imu.quaternion = {0.6F * scale, 0.0F, 0.8F * scale, 0.0F};
    read(true, true, true);
    return reading.quaternion;
  };
  BOOST_TEST((verdict(1.0F) == SensorVerdict::kGood && reading.has_quaternion));
  for (const float scale : {0.9F, 1.1F, 1e-6F}) {
    BOOST_TEST((verdict(scale) == SensorVerdict::kImplausible && !reading.has_quaternion));
  }
  BOOST_TEST((verdict(0.0F) == SensorVerdict::kZero && !reading.has_quaternion));
  BOOST_TEST((verdict(0.97F) == SensorVerdict::kGood && reading.has_quaternion));
  BOOST_TEST(std::abs(reading.R_world_base.norm() - 1.0) < 1e-12);
}

BOOST_AUTO_TEST_CASE(sample_noise_is_estimated_within_10_percent_during_motion) {
  for (const double sigma : {0.03, 0.1, 0.6}) {
    std::mt19937 generator(7);
    std::normal_distribution<double> normal(0.0, sigma);
    NoiseEstimator noise;
    noise.reset(0.1);
    BOOST_TEST(noise.sigma() == 0.1);
    for (int k = 0; k < 2500; ++k) {
      const double body = 3.0 * std::sin(6.28 * 2.0 * k * kPeriod);
      const Vector3 noise_vector(normal(generator), normal(generator), normal(generator));
      noise.update(Vector3(body, -body, kGravity) + noise_vector, kPeriod);
    }
    BOOST_TEST(std::abs(noise.sigma() / sigma - 1.0) < 0.1);
    noise.update(Vector3::Constant(100.0), kPeriod);  // an impact
    BOOST_TEST(noise.sigma() < 1.3 * sigma);
  }
  NoiseEstimator noise;
  noise.reset(0.1);
  for (int k = 0; k < 5000; ++k) noise.update(Vector3::Zero(), kPeriod);
  BOOST_TEST(noise.sigma() == 0.025);
}

BOOST_FIXTURE_TEST_CASE(three_stance_feet_determine_the_angular_rate, TurningBase) {
  Eigen::Vector4d contact = Eigen::Vector4d::Ones();
  Vector3 w = Vector3::Zero();
  BOOST_TEST(rate_from_legs(dynamics, contact, w));
  BOOST_TEST((w - w_base).norm() < 1e-9);
  contact[RL_] = 0.0;
  w.setZero();
  BOOST_TEST(rate_from_legs(dynamics, contact, w));
  BOOST_TEST((w - w_base).norm() < 1e-9);
  contact[FR_] = 0.4;
  w.setConstant(5.0);
  BOOST_TEST(!rate_from_legs(dynamics, contact, w));
  BOOST_TEST((w == Vector3::Constant(5.0)));
}

BOOST_FIXTURE_TEST_CASE(valid_sensor_is_averaged_over_the_tick, TurningBase) {
  ImuFilterInput preprocessor;
  imu.w_base = Vector3(1.0, 0.0, 0.0);
  step(preprocessor);
  imu.w_base = Vector3(1.02, 0.0, 0.0);
  imu.f_base.x() = 0.2;
  ImuInput fresh = step(preprocessor);
  BOOST_TEST((fresh.w_base - Vector3(1.01, 0.0, 0.0)).norm() < 1e-12);
  BOOST_TEST((fresh.f_base - Vector3(0.1, 0.0, kGravity)).norm() < 1e-12);
  fresh = step(preprocessor);
  const double sigma2 = gains.noise_gyroscope * gains.noise_gyroscope;
  BOOST_TEST(fresh.w_variance > 0.2 * sigma2);
  BOOST_TEST(fresh.w_variance < 2.0 * sigma2);
  imu.w_age = imu.f_age = 5;  // 8 ms old
  const ImuInput held = step(preprocessor);
  BOOST_TEST(held.w_variance > fresh.w_variance + 0.15);
  BOOST_TEST(held.f_variance > fresh.f_variance + 15.0);
}

BOOST_FIXTURE_TEST_CASE(frozen_gyroscope_is_replaced_by_quaternion_or_leg_rates, TurningBase) {
  imu.gyroscope = SensorVerdict::kConstant;
  imu.w_base = Vector3(9.0, 9.0, 9.0);
  ImuFilterInput preprocessor;
  const ImuInput by_legs = step(preprocessor);
  BOOST_TEST((by_legs.w_base - w_base).norm() < 1e-9);
  imu.R_world_base = imu.R_world_base * exp_so3(kPeriod * Vector3(0.2, 0.3, -0.1));
  const ImuInput by_quaternion = step(preprocessor);
  // The rotation that the legs measured meanwhile is not counted twice: the sum is the
  // quaternion's.
  const Vector3 both = by_legs.w_base + by_quaternion.w_base;
  BOOST_TEST((both - Vector3(0.2, 0.3, -0.1)).norm() < 1e-3);
  BOOST_TEST(by_quaternion.w_variance < by_legs.w_variance);
  imu.R_world_base = imu.R_world_base * exp_so3(Vector3(0.0, 0.0, 0.2));  // vendor resets its yaw
  BOOST_TEST((step(preprocessor).w_base - w_base).norm() < 1e-9);
  imu.has_quaternion = false;
  BOOST_TEST((step(preprocessor).w_base - w_base).norm() < 1e-9);
  const ImuInput blind = step(preprocessor, 0.0);
  BOOST_TEST(blind.w_base.norm() < 1e-12);
  BOOST_TEST(blind.w_variance > 10.0 * by_legs.w_variance);
  imu.gyroscope = SensorVerdict::kGood;
  BOOST_TEST((step(preprocessor).w_base - imu.w_base).norm() < 1e-12);
}

BOOST_FIXTURE_TEST_CASE(stopped_accelerometer_is_replaced_by_gravity_with_high_variance,
                        TurningBase) {
  const Quaternion tilted(Eigen::AngleAxisd(0.3, Vector3::UnitX()));
  filter.reset(tilted, Vector3::Zero(), Vector3::Zero(), FeetMatrix::Zero(), {});
  imu.f_base = Vector3(20.0, 0.0, 0.0);
  ImuFilterInput preprocessor;
  step(preprocessor);
  imu.accelerometer = SensorVerdict::kConstant;
  const ImuInput out = step(preprocessor);
  BOOST_TEST((out.f_base - tilted.conjugate() * Vector3(0.0, 0.0, kGravity)).norm() < 1e-12);
  BOOST_TEST(out.f_variance == 9.0);
}

BOOST_AUTO_TEST_CASE(quaternion_disagrees_after_1_s_of_contradiction) {
  const auto after = [](double seconds, const Quaternion& vendor, double sigma,
                        QuaternionTiltCheck& check) {
    ImuReading imu;
    imu.has_quaternion = true;
    imu.R_world_base = vendor;
    for (int k = 0; k < seconds / kPeriod; ++k) {
      check.update(imu, Matrix3::Identity(), sigma, kPeriod);
    }
    return check.verdict();
  };
  const Quaternion tilted(Eigen::AngleAxisd(0.15, Vector3::UnitY()));
  const Quaternion turned(Eigen::AngleAxisd(2.0, Vector3::UnitZ()));
  QuaternionTiltCheck check;
  BOOST_TEST((check.verdict() == SensorVerdict::kUnjudged));
  BOOST_TEST((after(3.0, turned, 0.0, check) == SensorVerdict::kGood));  // yaw is not observable
  BOOST_TEST((after(0.98, tilted, 0.01, check) == SensorVerdict::kGood));
  BOOST_TEST(std::abs(check.tilt_difference() - 0.15) < 1e-9);
  BOOST_TEST((after(0.04, tilted, 0.01, check) == SensorVerdict::kDisagrees));
  BOOST_TEST((after(1.1, turned, 0.01, check) == SensorVerdict::kGood));
  BOOST_TEST((after(3.0, tilted, 0.05, check) == SensorVerdict::kGood));  // our tilt is uncertain
  ImuReading none;
  none.quaternion = SensorVerdict::kZero;
  check.update(none, Matrix3::Identity(), 0.01, kPeriod);
  BOOST_TEST((check.verdict() == SensorVerdict::kZero));
}

BOOST_AUTO_TEST_CASE(accelerometer_starts_the_estimator_without_a_quaternion) {
  const Robot robot = quadruped();
  StateEstimator estimator(robot);
  const Quaternion tilted(Eigen::AngleAxisd(0.1, Vector3::UnitX()));
  for (std::uint32_t tick = 0; tick < 50; ++tick) {
    LowState report = resting_sample(robot, 2 * tick);
    report.imu.quaternion = {};
    report.imu.accelerometer = to_floats(tilted.conjugate() * Vector3(0.0, 0.0, kGravity));
    BOOST_TEST((estimator.update(report, kPeriod) == Status::kOk));
  }
  const auto q = estimator.state().q.segment<4>(3);
  BOOST_TEST(Quaternion(q[3], q[0], q[1], q[2]).angularDistance(tilted) < 0.01);
  BOOST_TEST((estimator.report().quaternion == SensorVerdict::kZero));
}

// The legs and the vendor's quaternion agree with each other, but not with the gyroscope.
BOOST_FIXTURE_TEST_CASE(legs_and_quaternion_outvote_a_wrong_gyroscope, TurningBase) {
  ImuFilterInput preprocessor;
  const auto turn = [&](const Vector3& w) {
    imu.R_world_base = imu.R_world_base * exp_so3(kPeriod * w);
  };
  const Vector3 rate_error(3.0, 0.0, 0.0);
  imu.w_base = w_base;
  for (int k = 0; k < 3; ++k, turn(w_base)) step(preprocessor);
  BOOST_TEST(!preprocessor.gyroscope_rejected());
  imu.w_base = w_base + rate_error;
  for (int k = 0; k < 20; ++k, turn(w_base)) {
    BOOST_TEST((step(preprocessor).w_base - w_base).norm() < 1e-6);
    BOOST_TEST(preprocessor.gyroscope_rejected());
  }
  imu.w_base = w_base;
  BOOST_TEST((step(preprocessor).w_base - w_base).norm() < 1e-6);  // the error leaves no trace
  BOOST_TEST(!preprocessor.gyroscope_rejected());
}

BOOST_FIXTURE_TEST_CASE(legs_alone_do_not_outvote_the_gyroscope, TurningBase) {
  imu.w_base = w_base + Vector3(3.0, 0.0, 0.0);
  for (const bool turns : {true, false}) {
    ImuFilterInput preprocessor;
    for (int k = 0; k < 5; ++k) {
      if (turns) imu.R_world_base = imu.R_world_base * exp_so3(kPeriod * imu.w_base);
      step(preprocessor);
      BOOST_TEST(!preprocessor.gyroscope_rejected());
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
