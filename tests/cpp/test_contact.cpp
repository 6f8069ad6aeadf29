// SPDX-License-Identifier: BSD-3-Clause
#include <boost/test/unit_test.hpp>
#include <functional>
#include <random>

#include "estimator/contact/contact_confidence.hpp"
#include "estimator/contact/foot_clearance.hpp"
#include "estimator/contact/leg_forces.hpp"
#include "estimator/contact/slip_detector.hpp"
#include "estimator/contact/torque_check.hpp"
#include "robot_states.hpp"

using namespace surefoot;

namespace {

constexpr double kPeriod = 0.002;
constexpr double kWeight = 118.0;  // [N]
constexpr int kEst = static_cast<int>(ContactSource::kFootForceEst);
constexpr int kCount = static_cast<int>(ContactSource::kFootForce);
constexpr int kTau = static_cast<int>(ContactSource::kTauEst);

// A contact confidence and its input. At first the robot stands and only the torques give a load.
struct ContactFixture {
  Gains gains;
  ContactConfidence contacts{kWeight};
  ContactSignals signals;
  int tick = 0;
  bool est_without_noise = false;  // footForceEst without the noise of its last digit
  ContactFixture() { signals.torque_load.setConstant(0.25); }
  void no_torques() {
    signals.tau_est = SensorVerdict::kZero;
    signals.torque_load.setZero();
  }
  // Leg `lifted` is in the air, and the other three carry the weight; -1: all four do.
  void lift(int lifted) {
    for (int leg = 0; leg < kLegs; ++leg)
      signals.torque_load[leg] = leg == lifted ? 0.0 : 1.0 / 3.0;
  }
  double confidence_after(double seconds, int leg = FL_) {
    for (int k = 0; k < seconds / kPeriod - 0.5; ++k) {
      ContactSignals now = signals;
      ++tick;
      for (std::int16_t& force : now.foot_force_est) {
        if (force > 10 && !est_without_noise) force = static_cast<std::int16_t>(force + tick % 2);
      }
      contacts.update(gains, now, kPeriod);
    }
    return contacts.confidence()[leg];
  }
  SensorVerdict verdict(int source, int leg = FL_) const {
    EstimatorReport report;
    contacts.write(report);
    return report.contact_sources[source][leg];
  }
};

// The calibration of one footForce sensor, with counts of a foot whose load changes.
struct CalibrationFixture {
  Gains gains;
  FootForceCalibration foot;
  ContactEvidence evidence;
  std::mt19937 generator{5};
  std::normal_distribution<double> normal;
  double t = 0.0;
  static double load(double t) {
    return 0.25 + 0.1 * std::sin(4.0 * t) + 0.05 * std::sin(11.0 * t);
  }
  void add_count(double count, double load) {
    evidence = foot.update(gains, static_cast<int>(std::lround(count)), load, true, true, kPeriod);
    t += kPeriod;
  }
  template <class Count>
  void run(double seconds, Count count) {
    for (const double end = t + seconds; t < end;) add_count(count(t), load(t));
  }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(contact)

BOOST_FIXTURE_TEST_CASE(torques_alone_detect_a_lifted_foot_within_the_dwell_time, ContactFixture) {
  BOOST_TEST(confidence_after(1.0) == 1.0);
  BOOST_TEST(!contacts.foot_force_est_works());
  lift(FL_);
  BOOST_TEST(confidence_after(kPeriod) == 0.8);  // one wrong sample moves it by one step
  lift(-1);
  BOOST_TEST(confidence_after(kPeriod) == 1.0);
  lift(FL_);
  BOOST_TEST(confidence_after(gains.contact_dwell - kPeriod) > 0.0);
  BOOST_TEST(confidence_after(2 * kPeriod) == 0.0);
  BOOST_TEST(confidence_after(1.0, FR_) == 1.0);
  signals.torque_load[FL_] = 0.5 * (gains.contact_force_on + gains.contact_force_off);
  BOOST_TEST(confidence_after(1.0) == 0.0);  // hysteresis
  lift(-1);
  BOOST_TEST(confidence_after(gains.contact_dwell + kPeriod) == 1.0);
  signals.torque_load[FL_] = 0.5 * (gains.contact_force_on + gains.contact_force_off);
  BOOST_TEST(confidence_after(1.0) == 1.0);
}

BOOST_FIXTURE_TEST_CASE(foot_force_est_alone_detects_a_lifted_foot, ContactFixture) {
  no_torques();
  signals.foot_force_est = {30, 30, 30, 30};
  BOOST_TEST(confidence_after(0.05) == 1.0);
  BOOST_TEST(!contacts.foot_force_est_works());
  confidence_after(0.1);
  BOOST_TEST(contacts.foot_force_est_works());
  signals.foot_force_est[FL_] = 1;
  BOOST_TEST(confidence_after(gains.contact_dwell + kPeriod) == 0.0);
  BOOST_TEST(confidence_after(0.1, RL_) == 1.0);
  signals.foot_force_est[FL_] = 30;
  BOOST_TEST(confidence_after(gains.contact_dwell + kPeriod) == 1.0);
  BOOST_TEST((verdict(kEst) == SensorVerdict::kGood && verdict(kTau) == SensorVerdict::kZero));
}

BOOST_FIXTURE_TEST_CASE(foot_force_counts_alone_detect_a_lift_from_their_observed_range,
                        ContactFixture) {
  no_torques();
  const auto noisy = [this](int tick, int fl) {
    const auto count = [&](int at) { return static_cast<std::int16_t>(at + (tick * 7) % 3); };
    signals.foot_force = {count(120), count(fl), count(120), count(120)};
    return confidence_after(kPeriod);
  };
  double confidence = 0.0;
  for (int tick = 0; tick < 200; ++tick) confidence = noisy(tick, 120);
  BOOST_TEST(confidence == 1.0);
  BOOST_TEST((verdict(kCount) == SensorVerdict::kUnjudged));
  for (int tick = 0; tick < 20; ++tick) confidence = noisy(tick, 60);
  BOOST_TEST(confidence == 0.0);
  BOOST_TEST(contacts.confidence()[FR_] == 1.0);
  BOOST_TEST((verdict(kCount) == SensorVerdict::kGood));
  for (int tick = 0; tick < 20; ++tick) confidence = noisy(tick, 120);
  BOOST_TEST(confidence == 1.0);
}

BOOST_FIXTURE_TEST_CASE(foot_speed_and_height_alone_end_and_restore_contact, ContactFixture) {
  no_torques();
  BOOST_TEST(confidence_after(1.0) == 1.0);
  signals.speed[FL_] = 0.2;  // neither moving nor at rest
  BOOST_TEST(confidence_after(1.0) == 1.0);
  signals.speed[FL_] = 0.5;
  BOOST_TEST(confidence_after(gains.contact_dwell + kPeriod) == 0.0);
  signals.speed[FL_] = 0.2;
  BOOST_TEST(confidence_after(1.0) == 0.0);
  signals.speed[FL_] = 0.0;
  BOOST_TEST(confidence_after(gains.contact_dwell) < 1.0);
  BOOST_TEST(confidence_after(2.0 * gains.contact_dwell) == 1.0);
  signals.clearance[FL_] = 0.005;  // soft ground
  BOOST_TEST(confidence_after(1.0) == 1.0);
  signals.clearance[FL_] = 0.012;
  BOOST_TEST(confidence_after(gains.contact_dwell + kPeriod) == 0.0);
}

BOOST_FIXTURE_TEST_CASE(contradicting_force_sources_leave_the_confidence_unchanged,
                        ContactFixture) {
  signals.foot_force_est = {30, 30, 30, 30};
  confidence_after(0.2);
  signals.load_factor = 1.2;  // the torque loads do not add up to it, so they get no extra weight
  signals.torque_load[FL_] = 0.0;
  BOOST_TEST(confidence_after(0.2) == 1.0);
  signals.foot_force_est[FL_] = 0;
  BOOST_TEST(confidence_after(0.02) == 0.0);
  signals.foot_force_est[FL_] = 30;
  BOOST_TEST(confidence_after(0.05) == 0.0);
}

BOOST_FIXTURE_TEST_CASE(torques_consistent_with_the_accelerometer_outvote_a_stuck_sensor,
                        ContactFixture) {
  signals.foot_force_est = {30, 30, 30, 30};
  confidence_after(0.2);
  lift(FL_);
  BOOST_TEST(confidence_after(0.1) == 0.0);
  BOOST_TEST((verdict(kEst) == SensorVerdict::kGood));
  confidence_after(0.35);
  BOOST_TEST((verdict(kEst) == SensorVerdict::kDisagrees));
  BOOST_TEST((verdict(kEst, FR_) == SensorVerdict::kGood));
  lift(-1);
  signals.foot_force_est[FL_] = 29;
  confidence_after(0.7);
  BOOST_TEST((verdict(kEst) == SensorVerdict::kGood));  // trusted again
}

BOOST_FIXTURE_TEST_CASE(constant_foot_force_under_changing_load_is_marked_constant,
                        ContactFixture) {
  est_without_noise = true;
  signals.foot_force_est = {30, 30, 30, 30};
  confidence_after(1.0);
  BOOST_TEST((verdict(kEst) == SensorVerdict::kGood));  // the load has not changed yet
  lift(FL_);
  BOOST_TEST(confidence_after(0.02) == 0.0);
  BOOST_TEST((verdict(kEst) == SensorVerdict::kConstant));
}

BOOST_FIXTURE_TEST_CASE(foot_force_and_foot_height_outvote_the_torques, ContactFixture) {
  signals.foot_force_est = {30, 30, 30, 30};
  confidence_after(0.2);
  signals.foot_force_est[FL_] = 0;
  signals.clearance[FL_] = 0.03;
  BOOST_TEST(confidence_after(0.2) == 0.0);
  BOOST_TEST(confidence_after(kPeriod, FR_) == 1.0);
}

BOOST_FIXTURE_TEST_CASE(raised_foot_has_no_contact_even_when_its_torques_carry_load,
                        ContactFixture) {
  confidence_after(0.2);
  signals.clearance[FL_] = 0.02;  // external lift of the foot
  BOOST_TEST(confidence_after(0.03) == 0.0);
  BOOST_TEST((verdict(kTau) == SensorVerdict::kGood));
  signals.clearance[FL_] = 0.0;
  BOOST_TEST(confidence_after(0.02) == 1.0);
}

BOOST_FIXTURE_TEST_CASE(two_failed_force_fields_of_one_foot_do_not_outvote_the_torques,
                        ContactFixture) {
  signals.foot_force_est = {30, 30, 30, 30};
  for (int k = 0; k < 100; ++k) {
    const auto count = static_cast<std::int16_t>(100 + k % 3);
    signals.foot_force = {count, count, count, count};
    confidence_after(kPeriod);
  }
  signals.foot_force_est[FL_] = signals.foot_force[FL_] = 0;
  double least = 1.0;
  for (int k = 0; k < 500; ++k) least = std::min(least, confidence_after(kPeriod));
  BOOST_TEST(least > 0.5);
  BOOST_TEST(contacts.confidence()[FL_] == 1.0);
}

BOOST_FIXTURE_TEST_CASE(torques_inconsistent_with_imu_and_foot_force_are_ignored, ContactFixture) {
  signals.foot_force_est = {29, 30, 29, 30};
  signals.torque_load.setConstant(0.01);  // they change, but are wrong from the start
  confidence_after(1.0);
  BOOST_TEST((verdict(kTau) == SensorVerdict::kDisagrees));
  BOOST_TEST((contacts.confidence() == Eigen::Vector4d::Ones()));
  BOOST_TEST((verdict(kEst) == SensorVerdict::kGood));
  signals.foot_force_est[FL_] = 0;
  BOOST_TEST(confidence_after(0.05) == 0.0);
}

BOOST_FIXTURE_TEST_CASE(resting_foot_regains_contact_when_no_force_source_is_left, ContactFixture) {
  confidence_after(0.2);
  lift(FL_);
  BOOST_TEST(confidence_after(0.05) == 0.0);
  no_torques();
  BOOST_TEST(confidence_after(2.0) == 1.0);
}

BOOST_FIXTURE_TEST_CASE(zero_foot_force_est_under_load_is_marked_dead, ContactFixture) {
  signals.foot_force_est = {30, 30, 30, 30};
  confidence_after(0.2);
  BOOST_TEST(contacts.foot_force_est_works());
  signals.foot_force_est = {};
  confidence_after(0.2);
  BOOST_TEST(!contacts.foot_force_est_works());
  BOOST_TEST((contacts.confidence() == Eigen::Vector4d::Ones()));
  contacts.reset();
  confidence_after(0.2);
  BOOST_TEST((verdict(kEst) == SensorVerdict::kZero));
}

BOOST_FIXTURE_TEST_CASE(zero_foot_force_est_in_the_air_stays_alive, ContactFixture) {
  signals.foot_force_est = {30, 30, 30, 30};
  confidence_after(0.2);
  signals.foot_force_est = {};
  signals.torque_load.setZero();
  signals.load_factor = 0.0;
  BOOST_TEST(confidence_after(1.0) == 0.0);
  BOOST_TEST(contacts.foot_force_est_works());
}

BOOST_FIXTURE_TEST_CASE(stray_counts_in_a_dead_foot_force_est_are_ignored, ContactFixture) {
  for (int tick = 0; tick < 1000; ++tick) {
    const auto stray = static_cast<std::int16_t>(tick % 7 == 0 ? 1 : 3);
    signals.foot_force_est = {stray, 0, 2, stray};
    confidence_after(kPeriod);
    BOOST_TEST(!contacts.foot_force_est_works());
  }
  BOOST_TEST((contacts.confidence() == Eigen::Vector4d::Ones()));
}

BOOST_AUTO_TEST_CASE(estimator_report_contains_the_contact_of_each_source) {
  ContactFixture b;
  b.signals.foot_force_est = {30, 30, 30, 30};
  b.confidence_after(0.2);
  b.lift(FL_);
  b.confidence_after(kPeriod);
  EstimatorReport report;
  b.contacts.write(report);
  BOOST_TEST(report.contact_by_source(kEst, FL_) > 0.95);
  BOOST_TEST(report.contact_by_source(kTau, FL_) < 0.05);
  BOOST_TEST(report.contact_by_source(kTau, FR_) > 0.95);
  BOOST_TEST(report.contact_by_source(kCount, FL_) == 0.5);
}

BOOST_FIXTURE_TEST_CASE(foot_count_learns_offset_and_scale_despite_noise_and_drift,
                        CalibrationFixture) {
  const auto offset = [](double at) { return 130.0 + 50.0 / 60.0 * at; };
  const double scale = 240.0;
  const auto count = [&](double load) {
    return offset(t) + scale * load + 2.0 * normal(generator);
  };
  run(0.01, [&](double at) { return count(load(at)); });
  BOOST_TEST((evidence.verdict == SensorVerdict::kUnjudged && evidence.vote == 0.0));
  run(60.0, [&](double at) { return count(load(at)); });
  BOOST_TEST((evidence.verdict == SensorVerdict::kGood));
  BOOST_TEST(std::abs(foot.scale() / scale - 1.0) < 0.1);
  BOOST_TEST(std::abs(foot.offset() - offset(t)) < 8.0);  // lags by 5 s of drift
  BOOST_TEST(evidence.vote > 0.9);
  double worst = -1.0;
  for (int k = 0; k < 100; ++k) {
    add_count(count(0.0), 0.0);
    worst = std::max(worst, evidence.vote);
  }
  BOOST_TEST(worst < 0.0);
}

BOOST_AUTO_TEST_CASE(counts_that_do_not_follow_the_load_are_ignored) {
  const auto verdict_of = [](std::function<double(double)> count) {
    CalibrationFixture c;
    c.run(10.0, count);
    BOOST_TEST(c.evidence.vote == 0.0);
    return c.evidence.verdict;
  };
  std::mt19937 generator(9);
  std::normal_distribution<double> normal;
  BOOST_TEST((verdict_of([](double) { return 0.0; }) == SensorVerdict::kZero));
  BOOST_TEST((verdict_of([](double) { return 137.0; }) == SensorVerdict::kConstant));
  BOOST_TEST((verdict_of([](double t) {
                return t < 5.0 ? 200.0 * CalibrationFixture::load(t) : 0.0;
              }) == SensorVerdict::kZero));
  BOOST_TEST((verdict_of([&](double) { return 137.0 + 3.0 * normal(generator); }) ==
              SensorVerdict::kConstant));
  BOOST_TEST((verdict_of([](double) { return 32767.0; }) == SensorVerdict::kSaturated));
  BOOST_TEST((verdict_of([](double) { return -32768.0; }) == SensorVerdict::kSaturated));
  BOOST_TEST((verdict_of([](double t) { return 200.0 + 60.0 * std::sin(23.0 * t); }) ==
              SensorVerdict::kDisagrees));
  BOOST_TEST((verdict_of([](double t) { return 300.0 - 200.0 * CalibrationFixture::load(t); }) ==
              SensorVerdict::kDisagrees));
}

BOOST_AUTO_TEST_CASE(torque_health_reports_zero_and_constant_torques) {
  TorqueCheck health;
  Vector12 tau = Vector12::Zero();
  health.update(tau, true, kPeriod);
  BOOST_TEST((health.verdict() == SensorVerdict::kZero));
  tau[3] = 1.0;
  health.update(tau, true, kPeriod);
  BOOST_TEST((health.verdict() == SensorVerdict::kGood));
  for (int k = 0; k < 500; ++k) health.update(tau, false, kPeriod);  // repeated samples
  for (int k = 0; k < 48; ++k) health.update(tau, true, kPeriod);
  BOOST_TEST((health.verdict() == SensorVerdict::kGood));
  for (int k = 0; k < 4; ++k) health.update(tau, true, kPeriod);
  BOOST_TEST((health.verdict() == SensorVerdict::kConstant));
  tau[7] = 0.1;
  health.update(tau, true, kPeriod);
  BOOST_TEST((health.verdict() == SensorVerdict::kGood));
}

BOOST_AUTO_TEST_CASE(single_moving_loaded_foot_slips_until_it_stops) {
  Gains gains;
  SlipDetector slip;
  FeetMatrix v = FeetMatrix::Zero();
  Eigen::Vector4d loaded = Eigen::Vector4d::Ones();
  const auto run = [&](double seconds) {
    const Eigen::Vector4d loads = 0.25 * loaded;
    const FootSlipInput input{v, loaded, loads, Vector3::UnitZ(), false};
    for (int k = 0; k < seconds / kPeriod; ++k) slip.update(gains, input, kPeriod);
  };
  v.row(0).setConstant(1.0);  // the same for all feet: an error of the base velocity
  run(0.5);
  BOOST_TEST(slip.slip().norm() == 0.0);
  v.setZero();
  run(0.5);
  v(1, RR_) = 0.5;
  run(0.005);
  BOOST_TEST(slip.slip()[RR_] < 0.5);
  run(0.1);
  BOOST_TEST((slip.slip() == Eigen::Vector4d(0.0, 0.0, 1.0, 0.0)));
  BOOST_TEST(std::abs(slip.speed()[RR_] - 0.5) < 1e-3);
  BOOST_TEST(slip.friction(gains)[RR_] == gains.slip_friction);
  BOOST_TEST(slip.friction(gains)[FR_] == 1.0);
  v.setZero();
  run(0.2);
  BOOST_TEST(slip.slip()[RR_] > 0.5);
  run(0.5);
  BOOST_TEST(slip.slip()[RR_] == 0.0);
  loaded[RR_] = 0.0;
  v(1, RR_) = 2.0;
  run(0.5);
  BOOST_TEST(slip.slip().norm() == 0.0);  // a swing foot does not slip
}

BOOST_AUTO_TEST_CASE(foot_clearance_is_measured_from_the_last_stance_height) {
  const Robot robot = quadruped();
  RobotState state = standing_state(robot);
  Dynamics dynamics(robot);
  dynamics.update(state.q, state.v, Vector3::UnitZ());
  InvariantFilter filter;
  filter.reset(Quaternion::Identity(), Vector3::Zero(), Vector3(0.0, 0.0, 0.1), FeetMatrix::Zero(),
               {});
  FootClearance clearance;
  FeetMatrix v = FeetMatrix::Zero();
  Eigen::Vector4d loaded = Eigen::Vector4d::Ones();
  std::array<bool, kLegs> loaded_by_forces{true, true, true, true};
  const auto run = [&](double seconds) {
    for (int k = 0; k < seconds / kPeriod; ++k) {
      clearance.update(dynamics, filter, v, loaded, loaded_by_forces, Vector3::UnitZ(), kPeriod);
    }
  };
  run(2.0);
  BOOST_TEST(clearance.clearance().norm() == 0.0);
  const double before = dynamics.legs()[FL_].p_world_contact.z();
  state.q[robot.motor_to_q()[FL_2]] -= 0.2;
  dynamics.update(state.q, state.v, Vector3::UnitZ());
  const double lifted = dynamics.legs()[FL_].p_world_contact.z() - before;
  BOOST_TEST(lifted > 0.01);
  loaded[FL_] = 0.0;
  v(0, FL_) = 0.05;  // external lift: its torques report load throughout
  run(3.0);
  BOOST_TEST((clearance.clearance() - lifted * Eigen::Vector4d::Unit(FL_)).norm() < 1e-9);
  loaded[FR_] = 0.0;  // the clearance is held while another foot is off the ground
  run(0.5);
  BOOST_TEST(std::abs(clearance.clearance()[FL_] - lifted) < 1e-9);
  loaded[FR_] = 1.0;
  v.setZero();
  run(3.5);  // it rests under load, so it stands there
  BOOST_TEST(std::abs(clearance.clearance()[FL_]) < 1e-3);
  state.q[robot.motor_to_q()[FL_2]] -= 0.2;
  dynamics.update(state.q, state.v, Vector3::UnitZ());
  loaded_by_forces[FL_] = false;  // the robot lifts the foot itself and puts it on a stone
  run(0.5);
  BOOST_TEST(clearance.clearance()[FL_] == 0.0);
  loaded_by_forces[FL_] = true;
  run(0.1);
  BOOST_TEST(std::abs(clearance.clearance()[FL_]) < 1e-9);
}

BOOST_AUTO_TEST_CASE(feet_landing_in_turn_have_zero_clearance) {
  const Robot robot = quadruped();
  const RobotState state = standing_state(robot);
  Dynamics dynamics(robot);
  dynamics.update(state.q, state.v, Vector3::UnitZ());
  FootClearance clearance;
  std::array<bool, kLegs> loaded_by_forces{};
  double height = 0.0;  // feet in the air do not measure the height, which drifts by 1 m/s
  for (const int lands : {FR_, FL_, RL_, RR_}) {
    loaded_by_forces[lands] = true;
    for (double t = 0.0; t < 0.02; t += kPeriod) {
      height += 1.0 * kPeriod;
      InvariantFilter filter;
      filter.reset(Quaternion::Identity(), Vector3::Zero(), Vector3(0.0, 0.0, height),
                   FeetMatrix::Zero(), {});
      clearance.update(dynamics, filter, FeetMatrix::Zero(), Eigen::Vector4d::Ones(),
                       loaded_by_forces, Vector3::UnitZ(), kPeriod);
    }
  }
  BOOST_TEST(clearance.clearance().norm() == 0.0);
}

BOOST_AUTO_TEST_CASE(leg_forces_recover_the_forces_behind_the_torques) {
  const Robot robot = quadruped();
  RobotState state = random_state(robot, 4, 0.8);
  state.v.head<3>().setZero();
  Eigen::VectorXd a = Eigen::VectorXd::Zero(robot.nv());
  a.head<6>() << 2.0, -1.0, 3.0, 4.0, -5.0, 6.0;
  FeetMatrix forces;
  forces << 5, -4, 3, 0, 2, 6, -7, 0, 30, 40, 20, 0;
  const Vector12 ddq = 20.0 * Vector12::Random();
  for (const double moving : {0.0, 1.0}) {
    for (int i = 0; i < kMotors; ++i) a[robot.motor_to_v()[i]] = moving * ddq[i];
    Dynamics dynamics(robot);
    dynamics.update(state.q, state.v, Vector3::UnitZ());
    const Eigen::VectorXd all = inverse_dynamics(robot, state, a);
    Vector12 tau, dq;
    for (int i = 0; i < kMotors; ++i) {
      const int leg = i / 3;
      tau[i] =
          all[robot.motor_to_v()[i]] - dynamics.legs()[leg].J_leg.col(i % 3).dot(forces.col(leg));
      dq[i] = state.v[robot.motor_to_v()[i]];
    }
    LegForces legs;
    // Keep the pose constant until the filter has settled; only the joint velocities change.
    const int ticks = moving > 0.0 ? 100 : 1;
    for (int k = 0; k < ticks; ++k) {
      legs.update(dynamics, a.head<3>(), a.segment<3>(3), tau, dq + moving * k * kPeriod * ddq,
                  Vector12::Zero(), kPeriod);
    }
    BOOST_TEST((legs.forces() - forces).norm() < 1e-6 * forces.norm());
    legs.reset();
    legs.update(dynamics, Vector3::Zero(), Vector3::Zero(), tau, dq, Vector12::Zero(), kPeriod);
    BOOST_TEST((legs.forces() - forces).norm() > 0.01 * forces.norm());  // the accelerations matter
  }
}

BOOST_AUTO_TEST_CASE(joints_near_their_limits_may_touch_a_mechanical_stop) {
  const Robot robot = quadruped();
  const RobotConfig& config = robot.config();
  Vector12 q = config.q_standing, expected = Vector12::Zero();
  q[FR_2] = config.q_upper[FR_2] - 0.01, expected[FR_2] = 1.0;
  q[FL_2] = config.q_upper[FL_2] + 0.02, expected[FL_2] = 1.0;  // mechanical stops are elastic
  q[RR_1] = config.q_lower[RR_1] + 0.01, expected[RR_1] = -1.0;
  q[RL_2] = config.q_upper[RL_2] - 0.05;
  BOOST_TEST((joint_stops(config, q) - expected).norm() == 0.0);
}

// Torque that presses a knee on its stop is not ground force. Torque in the other direction counts
// in full, because a stop only pushes.
BOOST_AUTO_TEST_CASE(torque_against_a_mechanical_stop_is_not_ground_force) {
  const Robot robot = quadruped();
  RobotState state = standing_state(robot);
  Dynamics dynamics(robot);
  dynamics.update(state.q, state.v, Vector3::UnitZ());
  const Vector12 resting = [&] {
    const Eigen::VectorXd all = inverse_dynamics(robot, state, Eigen::VectorXd::Zero(robot.nv()));
    Vector12 tau;
    for (int i = 0; i < kMotors; ++i) tau[i] = all[robot.motor_to_v()[i]];
    return tau;
  }();
  const auto force = [&](double tau, double stop) {
    LegForces legs;
    Vector12 torques = resting, stops = Vector12::Zero();
    torques[FR_2] += tau;
    stops[FR_2] = stop;
    legs.update(dynamics, Vector3::Zero(), Vector3::Zero(), torques, Vector12::Zero(), stops,
                kPeriod);
    return legs.forces().col(FR_).norm();
  };
  for (const double stop : {1.0, -1.0}) {
    BOOST_TEST(force(stop * 6.0, stop) < 1e-9);
    BOOST_TEST(force(stop * 6.0, 0.0) > 10.0);
    BOOST_TEST(force(-stop * 6.0, stop) == force(-stop * 6.0, 0.0));
  }
}

BOOST_AUTO_TEST_SUITE_END()
