// SPDX-License-Identifier: BSD-3-Clause
// What each monitor of the supervisor detects, and what it must not detect.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <random>

#include "supervisor/faults/alternation.hpp"
#include "supervisor/faults/clock_monitor.hpp"
#include "supervisor/faults/encoder_monitor.hpp"
#include "supervisor/faults/fault_log.hpp"
#include "supervisor/faults/joint_monitor.hpp"

using namespace surefoot;

namespace {

constexpr double kTick = 0.002;  // [s]
constexpr int kNoLeg = -1;

/// Swinging thighs and calves, as encoders measure them: quantised angles, noisy velocities.
struct SwingingJoints {
  std::mt19937 random{1};
  std::normal_distribution<double> noise{0.0, 0.05};  // [rad/s]
  double speed = 0.6;                                 // [rad/s] largest
  double time = 0.0;
  LowState report{};

  const LowState& next() {
    time += kTick;
    for (int i = 0; i < kMotors; ++i) {
      const double size = i % kLegJoints == 0 ? 0.0 : speed;
      const double phase = 3.0 * time + 0.1 * i;
      report.motorState[i].q = float(std::round(size / 3.0 * std::sin(phase) / 3e-5) * 3e-5);
      report.motorState[i].dq = float(size * std::cos(phase) + noise(random));
    }
    return report;
  }
  /// Set the joints of a leg back to an earlier sample.
  void freeze_leg(const LowState& before, int leg) {
    for (int i = kLegJoints * leg; i < kLegJoints * (leg + 1); ++i) {
      report.motorState[i].q = before.motorState[i].q;
      report.motorState[i].dq = before.motorState[i].dq;
    }
  }
};

/// Return the number of ticks until see() returns true, at most `most`.
template <typename See>
int ticks_until(int most, See&& see) {
  for (int k = 1; k <= most; ++k) {
    if (see()) return k;
  }
  return most;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(monitors)

BOOST_FIXTURE_TEST_CASE(stopped_encoders_are_detected_within_60_ms, SwingingJoints) {
  for (const double fastest : {0.25, 0.6, 3.0}) {
    speed = fastest;
    time = 0.0;
    EncoderMonitor watch;
    for (int k = 0; k < 20; ++k) watch.update(next(), kTick, kNoLeg);
    const LowState kept = report;
    const int ticks = ticks_until(100, [&] {
      next();
      freeze_leg(kept, 1);
      watch.update(report, kTick, kNoLeg);
      return watch.motor() >= 0;
    });
    BOOST_TEST(ticks <= 30);
    BOOST_TEST(ticks >= 5);
    BOOST_TEST(watch.motor() / kLegJoints == 1);
  }
}

BOOST_FIXTURE_TEST_CASE(moving_resting_or_slow_joints_are_not_dead_encoders, SwingingJoints) {
  EncoderMonitor watch;
  for (int k = 0; k < 5000; ++k) {
    watch.update(next(), kTick, kNoLeg);
    BOOST_REQUIRE(watch.motor() < 0);
  }
  for (int k = 0; k < 5000; ++k) {  // joints at 50 Hz, samples at 500 Hz
    if (k % 10 == 0) next();
    watch.update(report, kTick, kNoLeg);
    BOOST_REQUIRE(watch.motor() < 0);
  }
  const LowState kept = report;  // a leg at rest whose velocities have an offset
  for (int k = 0; k < 5000; ++k) {
    next();
    freeze_leg(kept, 2);
    for (int i = 6; i < 9; ++i) report.motorState[i].dq = 0.05F;
    watch.update(report, kTick, kNoLeg);
    BOOST_REQUIRE(watch.motor() < 0);
  }
}

BOOST_FIXTURE_TEST_CASE(lost_leg_raises_no_encoder_or_joint_fault, SwingingJoints) {
  EncoderMonitor encoders;
  JointMonitor joints;
  for (int k = 0; k < 20; ++k) encoders.update(next(), kTick, 1);
  BOOST_TEST(joints.update(report, kTick, 1));
  const LowState kept = report;
  for (int k = 0; k < 100; ++k) {
    next();
    freeze_leg(kept, 1);
    encoders.update(report, kTick, 1);
    BOOST_REQUIRE(encoders.motor() < 0);
    report.motorState[4].q = k % 2 == 0 ? 1.0F : -1.0F;
    BOOST_REQUIRE(joints.update(report, kTick, 1));
    report.motorState[7].q += 1.0F;
    BOOST_REQUIRE(!joints.update(report, kTick, 1));
    report.motorState[7].q -= 1.0F;
    BOOST_REQUIRE(joints.update(report, kTick, 1));
  }
}

BOOST_AUTO_TEST_CASE(fault_log_names_the_last_motor_with_the_fault) {
  FaultLog log;
  log.set(FaultId::kTemperature, true, RR_2);
  log.set(FaultId::kTemperature, true, FL_1);
  BOOST_TEST(log.report().motor[static_cast<int>(FaultId::kTemperature)] == FL_1);
  log.set(FaultId::kTemperature, false, FR_0);
  BOOST_TEST(log.report().motor[static_cast<int>(FaultId::kTemperature)] == FL_1);
  BOOST_TEST(log.report().count[static_cast<int>(FaultId::kTemperature)] == 1U);
}

BOOST_FIXTURE_TEST_CASE(clock_at_twice_the_rate_is_detected_within_200_ms, SwingingJoints) {
  ClockMonitor watch;
  for (int k = 0; k < 500; ++k) watch.update(next(), kTick);
  BOOST_TEST(!watch.fast());
  const int ticks = ticks_until(500, [&] {
    watch.update(next(), 2.0 * kTick);
    return watch.fast();
  });
  BOOST_TEST(kTick * ticks <= 0.2);
}

BOOST_FIXTURE_TEST_CASE(clock_at_half_of_the_rate_is_slow_within_300_ms, SwingingJoints) {
  ClockMonitor watch;
  for (int k = 0; k < 1000; ++k) watch.update(next(), kTick);
  BOOST_TEST(!watch.slow());
  int ticks = 0;
  for (; ticks < 1000 && !watch.slow(); ++ticks) watch.update(next(), 0.5 * kTick);
  BOOST_TEST(0.5 * kTick * ticks <= fault_info(FaultId::kClock).stepping_detection_time);
  BOOST_TEST(!watch.fast());
}

BOOST_FIXTURE_TEST_CASE(correct_or_slow_clock_and_wrong_speeds_raise_no_fault, SwingingJoints) {
  ClockMonitor watch;
  const auto expect_quiet = [&](auto&& modify_sample, double step) {
    for (int k = 0; k < 5000; ++k) {
      next();
      modify_sample(k);
      watch.update(report, step);
      BOOST_REQUIRE(!watch.fast());
    }
  };
  expect_quiet([](int) {}, kTick);
  expect_quiet([](int) {}, 0.5 * kTick);
  expect_quiet([&](int k) { report.motorState[5].dq = k % 25 == 0 ? 25.0F : 0.0F; }, kTick);
  expect_quiet([&](int) { freeze_leg(LowState{}, 3); }, kTick);
  expect_quiet(  // four calves that report 5 rad/s in two samples of ten
      [&](int k) {
        for (const int i : {2, 5, 8, 11}) {
          if (k % 10 < 2) report.motorState[i].dq = std::copysign(5.0F, report.motorState[i].dq);
        }
      },
      kTick);
  speed = 0.0;
  expect_quiet([](int) {}, 2.0 * kTick);  // at rest the clock cannot be checked
  expect_quiet(
      [&](int) {
        for (int i = 0; i < kMotors; ++i) report.motorState[i].dq += float(20.0 * noise(random));
      },
      kTick);
}

BOOST_AUTO_TEST_CASE(alternation_is_distinguished_from_motion_and_steps) {
  constexpr double kShare = 0.04;
  const auto settled = [](auto&& signal) {
    Alternation alternation;
    double mean = 0.0;
    for (int k = 0; k < 500; ++k) mean = alternation.update(signal(k), kShare);
    return mean;
  };
  BOOST_TEST(settled([](int k) { return k % 2 ? 1.0 : -1.0; }) > 3.9);
  BOOST_TEST(settled([](int k) { return k % 3 ? 1.0 : -1.0; }) > 1.0);
  BOOST_TEST(settled([](int k) { return 5.0 * std::sin(0.05 * k); }) < 0.0);
  BOOST_TEST(settled([](int k) { return k / 10 % 2 ? 5.0 : -5.0; }) <= 0.0);
}

BOOST_AUTO_TEST_CASE(one_wrong_sample_in_ten_is_not_frequent) {
  std::mt19937 random{7};
  std::normal_distribution<double> noise{0.0, 0.1};
  const auto ever = [&](int begin, auto&& wrong) {
    Alternation alternation;
    bool often = false;
    for (int k = 0; k < 1000; ++k) {
      alternation.update((k > begin && wrong(k) ? 0.0 : 5.0) + noise(random), 0.04, 0.5);
      often |= alternation.is_frequent();
    }
    return often;
  };
  BOOST_TEST(!ever(1000, [](int) { return true; }));
  BOOST_TEST(!ever(200, [](int k) { return k % 10 == 0; }));
  BOOST_TEST(ever(200, [](int k) { return k % 2 == 0; }));
  BOOST_TEST(ever(200, [](int k) { return k % 3 == 0; }));
}

BOOST_AUTO_TEST_SUITE_END()
