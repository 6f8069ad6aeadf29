// SPDX-License-Identifier: BSD-3-Clause
// Soft soles sink while their load rises, and a walking robot loads and unloads its feet.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "estimator/contact/sole_load.hpp"
#include "estimator/contact/step_detector.hpp"
#include "estimator/filter/invariant_filter.hpp"

using namespace surefoot;

namespace {

constexpr double kPeriod = 0.002;
constexpr double kPi = 3.14159265358979;

// A body at rest whose feet carry it in turn, one pair after the other, on soft soles.
struct ShiftingBody {
  double compliance = 0.02;  // [m] sink under the whole weight
  Gains gains;
  InvariantFilter filter;
  SoleLoad sole_load;
  FeetMatrix feet;
  Vector3 p{0.0, 0.0, 0.3};
  double t = 0.0, rms_speed = 0.0;  // [m/s] RMS error of the velocity in run()

  explicit ShiftingBody(double sole_sigma) {
    feet << 0.2, 0.2, -0.2, -0.2, -0.15, 0.15, -0.15, 0.15, 0.0, 0.0, 0.0, 0.0;
    filter.reset(Quaternion::Identity(), Vector3::Zero(), p, feet,
                 {0.01, 0.01, 0.002, 0.0, 0.0, sole_sigma});
  }
  // Loads [weight], 2.5 strides a second.
  Eigen::Vector4d loads() const {
    const double wave = 0.7 * std::sin(2.0 * kPi * 2.5 * t);
    const double first = std::max(wave, 0.0), second = std::max(-wave, 0.0);
    return {first, second, second, first};
  }
  void run(double seconds) {
    double sum = 0.0;
    int ticks = 0;
    for (const double end = t + seconds; t < end; t += kPeriod) {
      ImuInput imu;
      imu.f_base = kGravity * Vector3::UnitZ();
      imu.w_variance = 1e-4;
      imu.f_variance = 9.0;
      imu.dt = kPeriod;
      Eigen::Vector4d foot_variance;
      for (int leg = 0; leg < kLegs; ++leg) foot_variance[leg] = loads()[leg] < 0.02 ? 1e-2 : 1e-9;
      filter.predict(gains, imu, foot_variance, sole_load.process_variance(0.02, kPeriod));
      sole_load.update(loads(), true, kPeriod);
      FeetInput input;
      input.y_base = feet.colwise() - p;
      input.y_base.row(2) -= compliance * loads().transpose();
      input.variance.setConstant(1e-7);
      input.load = sole_load.load();
      input.normal_variance = sole_load.sink_variance(filter.sole_compliance(), kPeriod);
      input.load_changes = sole_load.changes();
      filter.correct(input, 4.0);
      sum += filter.v().squaredNorm();
      ++ticks;
    }
    rms_speed = std::sqrt(sum / ticks);
  }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(soft_soles)

BOOST_AUTO_TEST_CASE(sole_compliance_is_learnt_while_loads_change) {
  ShiftingBody body(0.02);
  body.run(4.0);
  BOOST_TEST(body.filter.sole_compliance() == 0.02, boost::test_tools::tolerance(0.1));
  body.run(1.0);

  ShiftingBody rigid(0.0);  // a filter that believes in rigid soles
  rigid.run(5.0);
  rigid.run(1.0);
  BOOST_TEST(body.rms_speed < 0.5 * rigid.rms_speed);
}

BOOST_AUTO_TEST_CASE(rigid_soles_are_learnt_too) {
  ShiftingBody body(0.02);
  body.compliance = 0.0;
  body.run(4.0);
  BOOST_TEST(body.filter.sole_compliance() < 1e-3);
}

BOOST_AUTO_TEST_CASE(noise_of_the_loads_at_rest_does_not_move_the_soles) {
  SoleLoad sole_load;
  double smallest = 1.0, largest = 0.0;
  for (int k = 0; k < 1000; ++k) {
    sole_load.update(Eigen::Vector4d::Constant(k % 2 == 0 ? 0.24 : 0.26), false, kPeriod);
    if (k < 10) continue;
    smallest = std::min(smallest, sole_load.load()[0]);
    largest = std::max(largest, sole_load.load()[0]);
    BOOST_REQUIRE(!sole_load.changes()[0]);
  }
  BOOST_TEST(smallest == largest);
  sole_load.update(Eigen::Vector4d(0.5, 0.25, 0.25, 0.0), false, kPeriod);
  BOOST_TEST((sole_load.changes()[0] && sole_load.changes()[3]));
  BOOST_TEST(!sole_load.changes()[1]);
}

BOOST_AUTO_TEST_CASE(touchdowns_of_two_pairs_are_steps) {
  StepDetector detector;
  const auto run = [&](const Eigen::Vector4d& contact, double seconds) {
    for (double t = 0.0; t < seconds; t += kPeriod) detector.update(contact, kPeriod);
  };
  const Eigen::Vector4d first(1, 0, 0, 1), second(0, 1, 1, 0);
  run(Eigen::Vector4d::Ones(), 1.0);
  BOOST_TEST((detector.rests() && !detector.steps()));
  run(first, 0.2);
  BOOST_TEST(!detector.rests());
  run(second, 0.2);  // first touchdown
  BOOST_TEST(!detector.steps());
  run(first, 0.2);  // second touchdown
  BOOST_TEST(detector.steps());
  run(Eigen::Vector4d::Ones(), 0.2);
  BOOST_TEST((detector.steps() && !detector.rests()));
  run(Eigen::Vector4d::Ones(), 1.0);
  BOOST_TEST((detector.rests() && !detector.steps()));
}

BOOST_AUTO_TEST_CASE(soles_count_as_moving_for_300_ms_after_the_last_planned_step) {
  StepDetector detector;
  const auto run = [&](double seconds) {
    for (double t = 0.0; t < seconds - 0.5 * kPeriod; t += kPeriod)
      detector.update(Eigen::Vector4d::Ones(), kPeriod);
  };
  run(1.0);
  BOOST_TEST((detector.rests() && !detector.stepped_lately()));
  detector.set_planned(true);
  BOOST_TEST((detector.steps() && detector.stepped_lately() && !detector.rests()));
  run(0.1);
  detector.set_planned(false);
  run(0.29);
  BOOST_TEST((!detector.steps() && detector.stepped_lately()));
  run(0.02);
  BOOST_TEST(!detector.stepped_lately());
}

BOOST_AUTO_TEST_CASE(one_impact_is_no_step) {
  StepDetector detector;
  const auto run = [&](const Eigen::Vector4d& contact, double seconds) {
    for (double t = 0.0; t < seconds; t += kPeriod) detector.update(contact, kPeriod);
  };
  run(Eigen::Vector4d::Zero(), 0.5);  // the robot falls
  run(Eigen::Vector4d(1, 0, 0, 0), 0.02);
  run(Eigen::Vector4d(0, 1, 1, 0), 0.02);  // feet bounce
  run(Eigen::Vector4d::Ones(), 0.5);
  BOOST_TEST(!detector.steps());
}

BOOST_AUTO_TEST_SUITE_END()
