// SPDX-License-Identifier: BSD-3-Clause
// What each of the supervisor's small observers sees, and what it must not.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <random>

#include "supervisor/clock_watch.hpp"
#include "supervisor/encoder_watch.hpp"
#include "supervisor/fault_log.hpp"
#include "supervisor/joint_watch.hpp"
#include "supervisor/zigzag.hpp"

using namespace surefoot;

namespace {

constexpr double kTick = 0.002;  // [s]
constexpr int kNoLeg = -1;

/// Thighs and calves that swing, measured as encoders do: rounded angles, noisy speeds.
struct Swinging {
  std::mt19937 random{1};
  std::normal_distribution<double> noise{0.0, 0.05};  // [rad/s]
  double speed = 0.6;                                 // [rad/s] greatest
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
  /// The leg's joints as they were.
  void keep(const LowState& before, int leg) {
    for (int i = kLegJoints * leg; i < kLegJoints * (leg + 1); ++i) {
      report.motorState[i].q = before.motorState[i].q;
      report.motorState[i].dq = before.motorState[i].dq;
    }
  }
};

/// [ticks] until it says so, or as many as there are
template <typename See>
int ticks_until(int most, See&& see) {
  for (int k = 1; k <= most; ++k) {
    if (see()) return k;
  }
  return most;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(watches)

BOOST_FIXTURE_TEST_CASE(encoders_that_stop_on_the_way_are_seen_in_sixty_milliseconds, Swinging) {
  for (const double fastest : {0.25, 0.6, 3.0}) {
    speed = fastest;
    time = 0.0;
    EncoderWatch watch;
    for (int k = 0; k < 20; ++k) watch.update(next(), kTick, kNoLeg);
    const LowState kept = report;
    const int ticks = ticks_until(100, [&] {
      next();
      keep(kept, 1);
      watch.update(report, kTick, kNoLeg);
      return watch.motor() >= 0;
    });
    BOOST_TEST(ticks <= 30);
    BOOST_TEST(ticks >= 5);
    BOOST_TEST(watch.motor() / kLegJoints == 1);
  }
}

BOOST_FIXTURE_TEST_CASE(joints_that_swing_or_rest_or_report_seldom_are_no_dead_encoders, Swinging) {
  EncoderWatch watch;
  for (int k = 0; k < 5000; ++k) {
    watch.update(next(), kTick, kNoLeg);
    BOOST_REQUIRE(watch.motor() < 0);
  }
  for (int k = 0; k < 5000; ++k) {  // joints at 50 Hz under a link at 500
    if (k % 10 == 0) next();
    watch.update(report, kTick, kNoLeg);
    BOOST_REQUIRE(watch.motor() < 0);
  }
  const LowState kept = report;  // a leg at rest whose speeds have an offset
  for (int k = 0; k < 5000; ++k) {
    next();
    keep(kept, 2);
    for (int i = 6; i < 9; ++i) report.motorState[i].dq = 0.05F;
    watch.update(report, kTick, kNoLeg);
    BOOST_REQUIRE(watch.motor() < 0);
  }
}

BOOST_FIXTURE_TEST_CASE(of_a_leg_that_was_given_up_nothing_is_expected, Swinging) {
  EncoderWatch encoders;
  JointWatch joints;
  for (int k = 0; k < 20; ++k) encoders.update(next(), kTick, 1);
  BOOST_TEST(joints.update(report, kTick, 1));
  const LowState kept = report;
  for (int k = 0; k < 100; ++k) {
    next();
    keep(kept, 1);
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

BOOST_AUTO_TEST_CASE(a_fault_is_at_the_motor_where_it_was_seen_last) {
  FaultLog log;
  log.set(FaultId::kTemperature, true, RR_2);
  log.set(FaultId::kTemperature, true, FL_1);
  BOOST_TEST(log.report().motor[static_cast<int>(FaultId::kTemperature)] == FL_1);
  log.set(FaultId::kTemperature, false, FR_0);
  BOOST_TEST(log.report().motor[static_cast<int>(FaultId::kTemperature)] == FL_1);
  BOOST_TEST(log.report().count[static_cast<int>(FaultId::kTemperature)] == 1U);
}

BOOST_FIXTURE_TEST_CASE(a_clock_twice_as_fast_is_seen_by_joints_that_move, Swinging) {
  ClockWatch watch;
  for (int k = 0; k < 500; ++k) watch.update(next(), kTick);
  BOOST_TEST(!watch.fast());
  const int ticks = ticks_until(500, [&] {
    watch.update(next(), 2.0 * kTick);
    return watch.fast();
  });
  BOOST_TEST(kTick * ticks <= 0.2);
}

BOOST_FIXTURE_TEST_CASE(a_clock_that_is_right_or_slow_and_speeds_that_lie_are_let_be, Swinging) {
  ClockWatch watch;
  const auto expect_quiet = [&](auto&& spoil, double step) {
    for (int k = 0; k < 5000; ++k) {
      next();
      spoil(k);
      watch.update(report, step);
      BOOST_REQUIRE(!watch.fast());
    }
  };
  expect_quiet([](int) {}, kTick);
  expect_quiet([](int) {}, 0.5 * kTick);
  expect_quiet([&](int k) { report.motorState[5].dq = k % 25 == 0 ? 25.0F : 0.0F; }, kTick);
  expect_quiet([&](int) { keep(LowState{}, 3); }, kTick);
  expect_quiet(  // four that turn faster than they do, in two reports of ten
      [&](int k) {
        for (const int i : {2, 5, 8, 11}) {
          if (k % 10 < 2) report.motorState[i].dq = std::copysign(5.0F, report.motorState[i].dq);
        }
      },
      kTick);
  speed = 0.0;
  expect_quiet([](int) {}, 2.0 * kTick);  // at rest there is nothing to see
  expect_quiet(
      [&](int) {
        for (int i = 0; i < kMotors; ++i) report.motorState[i].dq += float(20.0 * noise(random));
      },
      kTick);
}

BOOST_AUTO_TEST_CASE(what_alternates_is_told_from_what_moves_and_what_steps) {
  constexpr double kShare = 0.04;
  const auto settled = [](auto&& signal) {
    Zigzag zigzag;
    double mean = 0.0;
    for (int k = 0; k < 500; ++k) mean = zigzag.update(signal(k), kShare);
    return mean;
  };
  BOOST_TEST(settled([](int k) { return k % 2 ? 1.0 : -1.0; }) > 3.9);
  BOOST_TEST(settled([](int k) { return k % 3 ? 1.0 : -1.0; }) > 1.0);
  BOOST_TEST(settled([](int k) { return 5.0 * std::sin(0.05 * k); }) < 0.0);
  BOOST_TEST(settled([](int k) { return k / 10 % 2 ? 5.0 : -5.0; }) <= 0.0);
}

BOOST_AUTO_TEST_CASE(a_wrong_sample_in_ten_is_not_often_from_the_first_one_on) {
  std::mt19937 random{7};
  std::normal_distribution<double> noise{0.0, 0.1};
  const auto ever = [&](int begin, auto&& wrong) {
    Zigzag zigzag;
    bool often = false;
    for (int k = 0; k < 1000; ++k) {
      zigzag.update((k > begin && wrong(k) ? 0.0 : 5.0) + noise(random), 0.04, 0.5);
      often |= zigzag.often();
    }
    return often;
  };
  BOOST_TEST(!ever(1000, [](int) { return true; }));
  BOOST_TEST(!ever(200, [](int k) { return k % 10 == 0; }));
  BOOST_TEST(ever(200, [](int k) { return k % 2 == 0; }));
  BOOST_TEST(ever(200, [](int k) { return k % 3 == 0; }));
}

BOOST_AUTO_TEST_SUITE_END()
