// SPDX-License-Identifier: BSD-3-Clause
#include <boost/test/unit_test.hpp>
#include <initializer_list>

#include "link/tick_sequence.hpp"

using namespace surefoot;

namespace {

using V = TickSequence::Verdict;

/// Reports that come at the robot's pace, one every 2 ms, unless told otherwise.
struct Sequence : TickSequence {
  double time = 0.0;    // [s]
  double pace = 0.002;  // [s]
  Verdict take(std::uint32_t tick) { return TickSequence::take(tick, time += pace); }
};

// Begun, with a report every `period` ms up to `last`.
Sequence begun(std::uint32_t period, std::uint32_t last) {
  Sequence s;
  for (std::uint32_t k = 5; k-- > 0;) s.take(last - k * period);
  return s;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(tick_sequence)

BOOST_AUTO_TEST_CASE(nothing_is_lost_over_the_end_of_32_bits) {
  Sequence s;
  for (std::uint32_t tick = 0xFFFFFFF0; tick != 10; ++tick) {
    BOOST_REQUIRE((s.take(tick) == V::kNewer));
  }
  BOOST_TEST(s.lost() == 0U);
}

BOOST_AUTO_TEST_CASE(gaps_are_lost_until_what_was_late_comes_after_all) {
  Sequence s = begun(1, 9);
  BOOST_TEST((s.take(13) == V::kNewer));
  BOOST_TEST(s.lost() == 3U);
  BOOST_TEST((s.take(11) == V::kReordered));
  BOOST_TEST(s.lost() == 2U);
  for (const std::uint32_t again : {13, 11, 9, 11}) {
    BOOST_TEST((s.take(again) == V::kDuplicate));
  }
  BOOST_TEST(s.lost() == 2U);
  BOOST_TEST((s.take(2013) == V::kNewer));
  BOOST_TEST(s.lost() == 2001U);  // long silences too
}

BOOST_AUTO_TEST_CASE(the_period_is_what_comes_time_after_time) {
  Sequence s = begun(2, 100);
  BOOST_TEST((s.take(101) == V::kNewer));  // one odd step changes nothing
  BOOST_TEST((s.take(104) == V::kNewer));
  for (const std::uint32_t tick : {106, 108, 112}) s.take(tick);
  BOOST_TEST(s.lost() == 1U);
  const auto before = s.lost();
  for (std::uint32_t tick = 116; tick < 116 + 40; tick += 4) s.take(tick);
  const auto learning = s.lost();
  BOOST_TEST(learning > before);
  for (std::uint32_t tick = 156; tick < 156 + 40; tick += 4) s.take(tick);
  BOOST_TEST(s.lost() == learning);  // it reports half as often now
}

BOOST_AUTO_TEST_CASE(a_robot_that_begins_anew_is_told_by_a_row_of_old_ticks) {
  for (const std::uint32_t last : {800U, 50000U}) {
    Sequence s = begun(2, last);
    for (const std::uint32_t tick : {1, 3, 5, 7}) BOOST_TEST((s.take(tick) == V::kReordered));
    BOOST_TEST((s.take(9) == V::kRestarted));
    BOOST_TEST((s.take(11) == V::kNewer));
    BOOST_TEST((s.take(9) == V::kDuplicate));
  }
}

// A network that held some up delivers them at once; what came meanwhile is newer.
BOOST_AUTO_TEST_CASE(a_late_burst_is_no_new_beginning) {
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

BOOST_AUTO_TEST_CASE(one_that_began_anew_is_told_though_its_first_reports_came_at_once) {
  Sequence s = begun(2, 800);
  s.pace = 1e-6;
  std::uint32_t tick = 1;
  for (int k = 0; k < 6; ++k, tick += 2) BOOST_TEST((s.take(tick) == V::kReordered));
  s.pace = 0.002;
  int more = 0;
  for (; more < 10 && s.take(tick) != V::kRestarted; tick += 2) ++more;
  BOOST_TEST(more < 8);
}

BOOST_AUTO_TEST_CASE(old_reports_among_new_ones_are_no_new_beginning) {
  Sequence s = begun(2, 5000);
  for (std::uint32_t k = 1; k < 50; ++k) {
    BOOST_REQUIRE((s.take(5000 + 2 * k) == V::kNewer));
    BOOST_REQUIRE((s.take(2 * k) == V::kReordered));
  }
}

BOOST_AUTO_TEST_SUITE_END()
