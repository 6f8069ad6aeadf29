// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <boost/test/unit_test.hpp>

#include "surefoot/run_log.hpp"

using namespace surefoot;

namespace {

/// Make a log of `ticks` ticks, one per second.
RunLog log_of_ticks(std::size_t capacity, int ticks) {
  RunLog log(capacity);
  for (int k = 0; k < ticks; ++k) {
    RunTick tick;
    tick.time = k;
    tick.state.tick = 2 * k;
    log.add(tick);
  }
  return log;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(run_log)

BOOST_AUTO_TEST_CASE(log_keeps_the_last_ticks_in_order) {
  for (const int ticks : {0, 1, 2, 3, 4, 5, 6, 7}) {
    const RunLog log = log_of_ticks(3, ticks);
    const std::size_t size = std::min(ticks, 3);
    BOOST_REQUIRE(log.size() == size);
    for (std::size_t k = 0; k < size; ++k) {
      const auto expected = static_cast<double>(ticks - size + k);
      BOOST_TEST(log[k].time == expected);
      BOOST_TEST(log[k].state.tick == 2 * static_cast<std::uint32_t>(expected));
    }
  }
}

BOOST_AUTO_TEST_CASE(log_of_zero_capacity_stays_empty) {
  BOOST_TEST(log_of_ticks(0, 5).size() == 0U);
}

BOOST_AUTO_TEST_SUITE_END()
