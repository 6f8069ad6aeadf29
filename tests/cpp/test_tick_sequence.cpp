// SPDX-License-Identifier: BSD-3-Clause
#include <boost/test/unit_test.hpp>
#include <initializer_list>

#include "link/tick_sequence.hpp"

using namespace surefoot;

namespace {

using V = TickSequence::Arrival;

/// Samples that arrive every `pace`.
struct Sequence : TickSequence {
  double time = 0.0;    // [s]
  double pace = 0.002;  // [s]
  Arrival take(std::uint32_t tick) { return TickSequence::classify(tick, time += pace); }
};

// Start a sequence with a sample every `period` ms, up to tick `last`.
Sequence started_sequence(std::uint32_t period, std::uint32_t last) {
  Sequence s;
  for (std::uint32_t k = 5; k-- > 0;) s.take(last - k * period);
  return s;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(tick_sequence)

BOOST_AUTO_TEST_CASE(no_sample_is_counted_lost_across_the_32_bit_wrap) {
  Sequence s;
  for (std::uint32_t tick = 0xFFFFFFF0; tick != 10; ++tick) {
    BOOST_REQUIRE((s.take(tick) == V::kNewer));
  }
  BOOST_TEST(s.lost() == 0U);
}

BOOST_AUTO_TEST_CASE(late_samples_reduce_the_lost_count) {
  Sequence s = started_sequence(1, 9);
  BOOST_TEST((s.take(13) == V::kNewer));
  BOOST_TEST(s.lost() == 3U);
  BOOST_TEST((s.take(11) == V::kReordered));
  BOOST_TEST(s.lost() == 2U);
  for (const std::uint32_t again : {13, 11, 9, 11}) {
    BOOST_TEST((s.take(again) == V::kDuplicate));
  }
  BOOST_TEST(s.lost() == 2U);
  BOOST_TEST((s.take(2013) == V::kNewer));
  BOOST_TEST(s.lost() == 2001U);  // long gaps count too
}

BOOST_AUTO_TEST_CASE(period_is_the_repeated_tick_step) {
  Sequence s = started_sequence(2, 100);
  BOOST_TEST((s.take(101) == V::kNewer));  // one odd step changes nothing
  BOOST_TEST((s.take(104) == V::kNewer));
  for (const std::uint32_t tick : {106, 108, 112}) s.take(tick);
  BOOST_TEST(s.lost() == 1U);
  const auto before = s.lost();
  for (std::uint32_t tick = 116; tick < 116 + 40; tick += 4) s.take(tick);
  const auto learning = s.lost();
  BOOST_TEST(learning > before);
  for (std::uint32_t tick = 156; tick < 156 + 40; tick += 4) s.take(tick);
  BOOST_TEST(s.lost() == learning);  // the robot sends half as often now
}

BOOST_AUTO_TEST_CASE(restart_is_detected_from_consecutive_old_ticks) {
  for (const std::uint32_t last : {800U, 50000U}) {
    Sequence s = started_sequence(2, last);
    for (const std::uint32_t tick : {1, 3, 5, 7}) BOOST_TEST((s.take(tick) == V::kReordered));
    BOOST_TEST((s.take(9) == V::kRestarted));
    BOOST_TEST((s.take(11) == V::kNewer));
    BOOST_TEST((s.take(9) == V::kDuplicate));
  }
}

// A network that has held samples back delivers them in a burst, after newer samples.
BOOST_AUTO_TEST_CASE(late_burst_is_not_a_restart) {
  for (const std::uint32_t late : {6U, 90U, 900U}) {
    Sequence s;
    for (std::uint32_t tick = 1; tick <= 100; ++tick) s.take(tick);
    for (std::uint32_t tick = 113; tick <= 112 + late; ++tick) s.take(tick);
    s.pace = 1e-6;
    for (std::uint32_t tick = 101; tick <= 112; ++tick) {
      BOOST_TEST((s.take(tick) == V::kReordered));
    }
    s.pace = 0.002;
    BOOST_TEST((s.take(113 + late) == V::kNewer));
    BOOST_TEST(s.lost() == 0U);
  }
}

BOOST_AUTO_TEST_CASE(restart_is_detected_when_the_first_samples_arrive_in_a_burst) {
  Sequence s = started_sequence(2, 800);
  s.pace = 1e-6;
  std::uint32_t tick = 1;
  for (int k = 0; k < 6; ++k, tick += 2) BOOST_TEST((s.take(tick) == V::kReordered));
  s.pace = 0.002;
  int more = 0;
  for (; more < 10 && s.take(tick) != V::kRestarted; tick += 2) ++more;
  BOOST_TEST(more < 8);
}

BOOST_AUTO_TEST_CASE(old_samples_between_new_ones_are_not_a_restart) {
  Sequence s = started_sequence(2, 5000);
  for (std::uint32_t k = 1; k < 50; ++k) {
    BOOST_REQUIRE((s.take(5000 + 2 * k) == V::kNewer));
    BOOST_REQUIRE((s.take(2 * k) == V::kReordered));
  }
}

BOOST_AUTO_TEST_SUITE_END()
