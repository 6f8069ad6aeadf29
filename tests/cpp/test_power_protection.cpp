// SPDX-License-Identifier: BSD-3-Clause
// The SDK's protections: the truth table measured on the vendor's library, and where Surefoot
// differs.
#include <boost/test/unit_test.hpp>
#include <cstring>
#include <limits>

#include "quadruped.hpp"
#include "surefoot/safety.hpp"

using namespace surefoot;

namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInf = std::numeric_limits<float>::infinity();

LowState state_with_power(float watts, int motor = 0) {
  LowState state = init_low_state();
  state.motorState[motor].tauEst = 10.0F;
  state.motorState[motor].dq = 0.1F * watts;
  return state;
}

// A protection, called with a given power.
struct Guard {
  Safety safety{quadruped()};
  LowCmd cmd = init_low_cmd();
  int operator()(float watts, int level = 1) {
    return safety.power_protect(cmd, state_with_power(watts), level);
  }
  // Repeat a pattern of calls, 'x' above and '.' below 100 W. @return number of the first call that
  // trips; 0: none
  int first_trip(const char* pattern, int calls) {
    const std::size_t length = std::strlen(pattern);
    for (int k = 0; k < calls; ++k) {
      if ((*this)(pattern[k % length] == 'x' ? 101.0F : 0.0F) < 0) return k + 1;
    }
    return 0;
  }
  int trips_below_limit_after(int overloads) {
    for (int k = 0; k < overloads; ++k) (*this)(500.0F);
    int trips = 0;
    while ((*this)(0.0F) < 0) ++trips;
    return trips;
  }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(power_protection)

BOOST_AUTO_TEST_CASE(power_protection_trips_on_6_net_calls_above_the_limit) {
  BOOST_TEST(Guard().first_trip("x", 100) == 6);
  BOOST_TEST(Guard().first_trip("xx.", 100) == 14);
  BOOST_TEST(Guard().first_trip("x.", 1000) == 0);
  BOOST_TEST(Guard().first_trip("...x", 1000) == 0);
}

BOOST_AUTO_TEST_CASE(power_protection_recovers_within_5_calls_below_the_limit) {
  const int expected[] = {0, 1, 2, 3, 4, 4};
  for (int k = 0; k < 6; ++k) BOOST_TEST(Guard().trips_below_limit_after(6 + k) == expected[k]);
  BOOST_TEST(Guard().trips_below_limit_after(500) == 4);
  BOOST_TEST(Guard().trips_below_limit_after(5) == 0);
}

BOOST_AUTO_TEST_CASE(power_counter_stays_between_0_and_10) {
  Guard guard;
  for (const int expected : {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 10, 10}) {
    BOOST_TEST(guard(200.0F) == (expected > 5 ? -1 : 1));
    BOOST_TEST(guard.safety.power_counter() == expected);
  }
  for (const int expected : {9, 8, 7, 6, 5, 4, 3, 2, 1, 0, 0}) {
    BOOST_TEST(guard(0.0F) == (expected > 5 ? -1 : 1));
    BOOST_TEST(guard.safety.power_counter() == expected);
  }
}

BOOST_AUTO_TEST_CASE(power_level_is_100_w_and_is_clamped_to_1_to_10) {
  for (int level = -3; level <= 12; ++level) {
    const float limit = 100.0F * static_cast<float>(std::min(std::max(level, 1), 10));
    Guard equal, above;
    for (int k = 0; k < 20; ++k) {
      BOOST_TEST(equal(limit, level) == 1);
      above(limit + 1.0F, level);
    }
    BOOST_TEST(equal.safety.power_counter() == 0);
    BOOST_TEST(above.safety.power_counter() == 10);
    BOOST_TEST(equal.safety.power() == static_cast<double>(limit));
  }
}

BOOST_AUTO_TEST_CASE(raised_power_level_drains_the_counter) {
  Guard guard;
  for (int k = 0; k < 7; ++k) guard(150.0F);
  BOOST_TEST(guard(150.0F, 2) == -1);
  BOOST_TEST(guard(150.0F, 2) == 1);
  for (int k = 0; k < 4; ++k) guard(150.0F, 2);
  BOOST_TEST(guard.safety.power_counter() == 1);
  BOOST_TEST(guard(150.0F) == 1);
}

BOOST_AUTO_TEST_CASE(absolute_motor_powers_are_summed_and_empty_slots_ignored) {
  Safety safety(quadruped());
  const LowCmd cmd = init_low_cmd();
  LowState state = state_with_power(300.0F, RL_2);
  state.motorState[FR_0] = state_with_power(-300.0F).motorState[0];
  for (int slot = kMotors; slot < kMotorSlots; ++slot) state.motorState[slot].tauEst = kNan;
  safety.power_protect(cmd, state, 1);
  BOOST_TEST(safety.power() == 600.0);
  state = init_low_state();
  for (int slot = kMotors; slot < kMotorSlots; ++slot) {
    state.motorState[slot] = state_with_power(9000.0F, slot).motorState[slot];
  }
  for (int k = 0; k < 20; ++k) BOOST_TEST(safety.power_protect(cmd, state, 1) == 1);
  BOOST_TEST(safety.power() == 0.0);
}

BOOST_AUTO_TEST_CASE(non_finite_power_trips_at_once_and_counts_as_above_the_limit) {
  for (const float bad : {kNan, kInf, -kInf}) {
    for (const bool torque : {true, false}) {
      Guard guard;
      LowState state = state_with_power(50.0F, FL_1);
      (torque ? state.motorState[FL_1].tauEst : state.motorState[FL_1].dq) = bad;
      BOOST_TEST(guard.safety.power_protect(guard.cmd, state, 10) == -1);
      BOOST_TEST(guard.safety.power_counter() == 1);
      BOOST_TEST(guard(0.0F) == 1);
      for (int k = 0; k < 20; ++k) guard.safety.power_protect(guard.cmd, state, 10);
      BOOST_TEST(guard.safety.power_counter() == 10);
    }
  }
}

BOOST_AUTO_TEST_CASE(protections_do_not_change_the_command) {
  Guard guard;
  guard.cmd.motorCmd[3].tau = 5.0F;
  guard.cmd.motorCmd[4].q = kNan;
  const LowCmd before = guard.cmd;
  for (int k = 0; k < 20; ++k) guard(500.0F);
  LowState outside = init_low_state();
  outside.motorState[0].q = 9.0F;
  BOOST_TEST(guard.safety.position_protect(guard.cmd, outside) == -1);
  BOOST_TEST(std::memcmp(&before, &guard.cmd, sizeof(LowCmd)) == 0);
}

BOOST_AUTO_TEST_CASE(reset_clears_both_protections) {
  Guard guard;
  for (int k = 0; k < 20; ++k) guard(500.0F);
  guard.safety.position_protect(guard.cmd, init_low_state());
  guard.safety.reset();
  BOOST_TEST(guard.safety.power_counter() == 0);
  BOOST_TEST(guard.safety.power() == 0.0);
  BOOST_TEST(guard.safety.position_motor() == -1);
  BOOST_TEST(guard(500.0F) == 1);
}

BOOST_AUTO_TEST_SUITE_END()
