// SPDX-License-Identifier: BSD-3-Clause
#include <boost/test/unit_test.hpp>
#include <random>

#include "estimator/imu/inertial_input.hpp"
#include "estimator/imu/quaternion_check.hpp"
#include "scenes.hpp"
#include "surefoot/state_estimator.hpp"

using namespace surefoot;

namespace {

constexpr double kPeriod = 0.002;

std::array<float, 3> words(const Vector3& v) { return {float(v.x()), float(v.y()), float(v.z())}; }
std::array<float, 4> words(const Quaternion& q) {
  return {float(q.w()), float(q.x()), float(q.y()), float(q.z())};
}

// A reader and what it is given; gyroscope and accelerometer can be held, and so can the joints.
struct Reports {
  RobotConfig config = quadruped_config();
  ImuReader reader;
  ImuReading reading;
  IMU imu{};
  Vector12 joints = Vector12::Zero();
  int count = 0;
  Reports() {
    imu.quaternion = {1.0F, 0.0F, 0.0F, 0.0F};
    read(true, true, true);
  }
  void read(bool new_gyroscope, bool new_accelerometer, bool new_joints) {
    const double change = 1e-3 * ++count;
    if (new_gyroscope) imu.gyroscope = words(Vector3(0.1, change, 0.0));
    if (new_accelerometer) imu.accelerometer = words(Vector3(0.0, change, kGravity));
    if (new_joints) joints[4] = change;
    reader.read(imu, config, joints, kPeriod, reading);
  }
};

// Feet that stand, under a base that turns and travels.
struct Turning {
  Robot robot = quadruped();
  RobotState state = random_state(robot, 3);
  Dynamics dynamics{robot};
  Vector3 w_base{0.3, -0.5, 0.7};
  InvariantFilter filter;
  Gains gains;
  ImuReading imu;

  // @param w_believed what the dynamics take the rate for; as in the estimator, at no velocity
  explicit Turning(const Vector3& w_believed = Vector3(0.1, 0.2, -0.4)) {
    dynamics.update(state.q, state.v, Vector3::UnitZ());
    Vector6 twist;
    twist << 0.2, -0.1, 0.05, w_base;
    for (int leg = 0; leg < kLegs; ++leg) {
      const LegDynamics& one = dynamics.legs()[leg];
      const Vector3 dq = -one.J_leg.inverse() * (one.J_base * twist);
      for (int k = 0; k < 3; ++k) state.v[robot.motor_to_v()[3 * leg + k]] = dq[k];
    }
    state.v.head<6>() << Vector3::Zero(), w_believed;
    dynamics.update(state.q, state.v, Vector3::UnitZ());
    filter.reset(Quaternion::Identity(), Vector3::Zero(), Vector3::Zero(), FeetMatrix::Zero(),
                 {0.1, 0.1, 0.01, 0.01, 0.1});
    imu.gyroscope = imu.accelerometer = imu.quaternion = Verdict::kGood;
    imu.has_quaternion = true;
    imu.f_base = Vector3(0.0, 0.0, kGravity);
  }
  InertialStep step(InertialInput& input, double feet = 1.0) {
    return input.step(gains, imu, filter, dynamics, Eigen::Vector4d::Constant(feet), kPeriod);
  }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(imu_input)

BOOST_AUTO_TEST_CASE(a_turned_mount_is_turned_back) {
  Reports r;
  const Quaternion mount(Eigen::AngleAxisd(0.7, Vector3(1, 2, -1).normalized()));
  r.config.quat_base_imu << mount.w(), mount.x(), mount.y(), mount.z();
  const Quaternion base(Eigen::AngleAxisd(0.3, Vector3(0.2, 1, 0.5).normalized()));
  const Vector3 w_base(0.1, -0.2, 0.3), f_base(0.5, 1.0, 9.0);
  r.imu.quaternion = words(base * mount);
  r.imu.gyroscope = words(mount.conjugate() * w_base);
  r.imu.accelerometer = words(mount.conjugate() * f_base);
  r.read(false, false, true);
  BOOST_TEST(r.reading.R_world_base.angularDistance(base) < 1e-6);
  BOOST_TEST((r.reading.w_base - w_base).norm() < 1e-6);
  BOOST_TEST((r.reading.f_base - f_base).norm() < 1e-5);
}

BOOST_FIXTURE_TEST_CASE(held_samples_age_and_repeated_reports_do_not, Reports) {
  BOOST_TEST((reading.w_age == 1 && reading.f_age == 1));
  read(false, true, true);
  BOOST_TEST((reading.w_age == 2 && reading.f_age == 1));
  read(false, false, true);
  BOOST_TEST((reading.w_age == 3 && reading.f_age == 2));
  for (int k = 0; k < 100; ++k) read(false, false, false);
  BOOST_TEST((reading.w_age == 3 && reading.f_age == 2));
  BOOST_TEST((reading.gyroscope == Verdict::kGood));
  read(true, false, true);
  BOOST_TEST((reading.w_age == 1 && reading.f_age == 3));
}

BOOST_FIXTURE_TEST_CASE(a_sensor_has_stopped_after_22_ms_in_which_joints_move, Reports) {
  for (int k = 0; k < 10; ++k) {
    read(false, true, true);  // 20 ms: a 50 Hz sensor
    read(false, false, false);
  }
  BOOST_TEST((reading.gyroscope == Verdict::kGood));
  read(false, true, true);
  read(false, true, true);
  BOOST_TEST((reading.gyroscope == Verdict::kConstant));
  BOOST_TEST((reading.accelerometer == Verdict::kGood));
  read(true, false, true);
  BOOST_TEST((reading.gyroscope == Verdict::kGood));
  imu.accelerometer = {};
  for (int k = 0; k < 13; ++k) read(true, false, true);
  BOOST_TEST((reading.accelerometer == Verdict::kZero));
  imu.accelerometer = {0.0F, 0.0F, 9.8F};
  for (int k = 0; k < 13; ++k) read(true, false, true);
  BOOST_TEST((reading.accelerometer == Verdict::kConstant));
}

BOOST_FIXTURE_TEST_CASE(the_end_of_the_range_is_saturation, Reports) {
  imu.gyroscope = words(Vector3(0.0, 34.0, 0.0));
  imu.accelerometer = words(Vector3(0.0, 150.0, 0.0));
  read(false, false, true);
  BOOST_TEST((reading.gyroscope == Verdict::kGood && reading.accelerometer == Verdict::kGood));
  imu.gyroscope = words(Vector3(0.0, -34.9, 0.0));
  read(false, false, true);
  BOOST_TEST((reading.gyroscope == Verdict::kSaturated));
  BOOST_TEST((reading.accelerometer == Verdict::kGood));
  imu.accelerometer = words(Vector3(156.9, 0.0, 0.0));
  read(true, false, true);
  BOOST_TEST((reading.gyroscope == Verdict::kGood));
  BOOST_TEST((reading.accelerometer == Verdict::kSaturated));
}

BOOST_FIXTURE_TEST_CASE(a_quaternion_that_is_none_says_so_and_counts_for_nothing, Reports) {
  const auto verdict = [this](float scale) {
    imu.quaternion = {0.6F * scale, 0.0F, 0.8F * scale, 0.0F};
    read(true, true, true);
    return reading.quaternion;
  };
  BOOST_TEST((verdict(1.0F) == Verdict::kGood && reading.has_quaternion));
  for (const float scale : {0.9F, 1.1F, 1e-6F}) {
    BOOST_TEST((verdict(scale) == Verdict::kImplausible && !reading.has_quaternion));
  }
  BOOST_TEST((verdict(0.0F) == Verdict::kZero && !reading.has_quaternion));
  BOOST_TEST((verdict(0.97F) == Verdict::kGood && reading.has_quaternion));
  BOOST_TEST(std::abs(reading.R_world_base.norm() - 1.0) < 1e-12);
}

BOOST_AUTO_TEST_CASE(noise_of_samples_is_found_within_a_tenth_whatever_the_body_does) {
  for (const double sigma : {0.03, 0.1, 0.6}) {
    std::mt19937 generator(7);
    std::normal_distribution<double> normal(0.0, sigma);
    SampleNoise noise;
    noise.reset(0.1);
    BOOST_TEST(noise.sigma() == 0.1);
    for (int k = 0; k < 2500; ++k) {
      const double body = 3.0 * std::sin(6.28 * 2.0 * k * kPeriod);
      const Vector3 shaken(normal(generator), normal(generator), normal(generator));
      noise.update(Vector3(body, -body, kGravity) + shaken, kPeriod);
    }
    BOOST_TEST(std::abs(noise.sigma() / sigma - 1.0) < 0.1);
    noise.update(Vector3::Constant(100.0), kPeriod);  // a blow
    BOOST_TEST(noise.sigma() < 1.3 * sigma);
  }
  SampleNoise noise;
  noise.reset(0.1);
  for (int k = 0; k < 5000; ++k) noise.update(Vector3::Zero(), kPeriod);
  BOOST_TEST(noise.sigma() == 0.025);
}

BOOST_FIXTURE_TEST_CASE(three_standing_feet_tell_the_rate, Turning) {
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

BOOST_FIXTURE_TEST_CASE(a_good_sensor_is_taken_by_its_mean_over_the_tick, Turning) {
  InertialInput input;
  imu.w_base = Vector3(1.0, 0.0, 0.0);
  step(input);
  imu.w_base = Vector3(1.02, 0.0, 0.0);
  imu.f_base.x() = 0.2;
  InertialStep fresh = step(input);
  BOOST_TEST((fresh.w_base - Vector3(1.01, 0.0, 0.0)).norm() < 1e-12);
  BOOST_TEST((fresh.f_base - Vector3(0.1, 0.0, kGravity)).norm() < 1e-12);
  fresh = step(input);
  const double sigma2 = gains.noise_gyroscope * gains.noise_gyroscope;
  BOOST_TEST(fresh.w_variance > 0.2 * sigma2);
  BOOST_TEST(fresh.w_variance < 2.0 * sigma2);
  imu.w_age = imu.f_age = 5;  // old by 8 ms
  const InertialStep held = step(input);
  BOOST_TEST(held.w_variance > fresh.w_variance + 0.15);
  BOOST_TEST(held.f_variance > fresh.f_variance + 15.0);
}

BOOST_FIXTURE_TEST_CASE(a_frozen_gyroscope_is_replaced_by_the_quaternion_or_else_the_legs,
                        Turning) {
  imu.gyroscope = Verdict::kConstant;
  imu.w_base = Vector3(9.0, 9.0, 9.0);
  InertialInput input;
  const InertialStep by_legs = step(input);
  BOOST_TEST((by_legs.w_base - w_base).norm() < 1e-9);
  imu.R_world_base = imu.R_world_base * exp_so3(kPeriod * Vector3(0.2, 0.3, -0.1));
  const InertialStep by_quaternion = step(input);
  // What the legs have told meanwhile is not told twice: in all it is the quaternion's turn.
  const Vector3 both = by_legs.w_base + by_quaternion.w_base;
  BOOST_TEST((both - Vector3(0.2, 0.3, -0.1)).norm() < 1e-3);
  BOOST_TEST(by_quaternion.w_variance < by_legs.w_variance);
  imu.R_world_base = imu.R_world_base * exp_so3(Vector3(0.0, 0.0, 0.2));  // the vendor begins anew
  BOOST_TEST((step(input).w_base - w_base).norm() < 1e-9);
  imu.has_quaternion = false;
  BOOST_TEST((step(input).w_base - w_base).norm() < 1e-9);
  const InertialStep blind = step(input, 0.0);
  BOOST_TEST(blind.w_base.norm() < 1e-12);
  BOOST_TEST(blind.w_variance > 10.0 * by_legs.w_variance);
  imu.gyroscope = Verdict::kGood;
  BOOST_TEST((step(input).w_base - imu.w_base).norm() < 1e-12);
}

BOOST_FIXTURE_TEST_CASE(a_stopped_accelerometer_is_replaced_by_rest_in_great_doubt, Turning) {
  const Quaternion tilted(Eigen::AngleAxisd(0.3, Vector3::UnitX()));
  filter.reset(tilted, Vector3::Zero(), Vector3::Zero(), FeetMatrix::Zero(), {});
  imu.f_base = Vector3(20.0, 0.0, 0.0);
  InertialInput input;
  step(input);
  imu.accelerometer = Verdict::kConstant;
  const InertialStep out = step(input);
  BOOST_TEST((out.f_base - tilted.conjugate() * Vector3(0.0, 0.0, kGravity)).norm() < 1e-12);
  BOOST_TEST(out.f_variance == 9.0);
}

BOOST_AUTO_TEST_CASE(a_quaternion_disagrees_once_it_has_done_so_for_a_second) {
  const auto after = [](double seconds, const Quaternion& vendor, double sigma,
                        QuaternionCheck& check) {
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
  QuaternionCheck check;
  BOOST_TEST((check.verdict() == Verdict::kUnjudged));
  BOOST_TEST((after(3.0, turned, 0.0, check) == Verdict::kGood));  // nobody knows the yaw
  BOOST_TEST((after(0.98, tilted, 0.01, check) == Verdict::kGood));
  BOOST_TEST(std::abs(check.tilt_apart() - 0.15) < 1e-9);
  BOOST_TEST((after(0.04, tilted, 0.01, check) == Verdict::kDisagrees));
  BOOST_TEST((after(1.1, turned, 0.01, check) == Verdict::kGood));
  BOOST_TEST((after(3.0, tilted, 0.05, check) == Verdict::kGood));  // we know no better
  ImuReading none;
  none.quaternion = Verdict::kZero;
  check.update(none, Matrix3::Identity(), 0.01, kPeriod);
  BOOST_TEST((check.verdict() == Verdict::kZero));
}

BOOST_AUTO_TEST_CASE(without_a_quaternion_the_accelerometer_starts_the_estimator) {
  const Robot robot = quadruped();
  StateEstimator estimator(robot);
  const Quaternion tilted(Eigen::AngleAxisd(0.1, Vector3::UnitX()));
  for (std::uint32_t tick = 0; tick < 50; ++tick) {
    LowState report = resting_report(robot, 2 * tick);
    report.imu.quaternion = {};
    report.imu.accelerometer = words(tilted.conjugate() * Vector3(0.0, 0.0, kGravity));
    BOOST_TEST((estimator.update(report, kPeriod) == Status::kOk));
  }
  const auto q = estimator.state().q.segment<4>(3);
  BOOST_TEST(Quaternion(q[3], q[0], q[1], q[2]).angularDistance(tilted) < 0.01);
  BOOST_TEST((estimator.report().quaternion == Verdict::kZero));
}

// Legs and the vendor's quaternion agree, and not with the gyroscope.
BOOST_FIXTURE_TEST_CASE(a_gyroscope_that_two_others_contradict_is_outvoted, Turning) {
  InertialInput input;
  const auto turn = [&](const Vector3& w) {
    imu.R_world_base = imu.R_world_base * exp_so3(kPeriod * w);
  };
  const Vector3 lie(3.0, 0.0, 0.0);
  imu.w_base = w_base;
  for (int k = 0; k < 3; ++k, turn(w_base)) step(input);
  BOOST_TEST(!input.outvoted());
  imu.w_base = w_base + lie;
  for (int k = 0; k < 20; ++k, turn(w_base)) {
    BOOST_TEST((step(input).w_base - w_base).norm() < 1e-6);
    BOOST_TEST(input.outvoted());
  }
  imu.w_base = w_base;
  BOOST_TEST((step(input).w_base - w_base).norm() < 1e-6);  // nothing of the lie is left
  BOOST_TEST(!input.outvoted());
}

BOOST_FIXTURE_TEST_CASE(legs_alone_do_not_outvote_it, Turning) {
  imu.w_base = w_base + Vector3(3.0, 0.0, 0.0);
  for (const bool turns : {true, false}) {
    InertialInput input;
    for (int k = 0; k < 5; ++k) {
      if (turns) imu.R_world_base = imu.R_world_base * exp_so3(kPeriod * imu.w_base);
      step(input);
      BOOST_TEST(!input.outvoted());
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
