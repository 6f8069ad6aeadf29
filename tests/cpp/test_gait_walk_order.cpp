// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <boost/test/unit_test.hpp>

#include "gait/walk_order.hpp"
#include "quadruped.hpp"

using namespace surefoot;

namespace {

constexpr double kPeriod = 0.9;  // [s]
constexpr WalkOrder kForward = {RR_, FR_, RL_, FL_}, kBackward = {RR_, FL_, RL_, FR_},
                    kLeft = {RR_, RL_, FR_, FL_};

struct OrderFixture {
  GaitSize size{quadruped()};
  double margin = 0.17 * size.height;
  WalkOrder best(const WalkVelocity& velocity, const WalkOrder& present = kForward) const {
    return best_walk_order(present, size, velocity, kPeriod, margin);
  }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(gait_walk_order)

BOOST_FIXTURE_TEST_CASE(feet_step_in_the_lateral_sequence_of_the_direction_of_motion,
                        OrderFixture) {
  BOOST_TEST((best({0.25, 0.0, 0.0}, kBackward) == kForward));
  BOOST_TEST((best({-0.25, 0.0, 0.0}) == kBackward));
  // To the left, the front feet are what the right feet are in a walk forwards.
  BOOST_TEST((best({0.0, 0.25, 0.0}) == kLeft));
  BOOST_TEST((best({0.0, -0.25, 0.0}) == WalkOrder{RR_, FL_, FR_, RL_}));
}

BOOST_FIXTURE_TEST_CASE(turning_robot_lifts_its_feet_around_the_body, OrderFixture) {
  BOOST_TEST((best({0.0, 0.0, 0.6}) == WalkOrder{RR_, FR_, FL_, RL_}));
  BOOST_TEST((best({0.0, 0.0, -0.6}) == WalkOrder{RR_, RL_, FL_, FR_}));
}

BOOST_FIXTURE_TEST_CASE(best_order_needs_the_least_sway_of_all, OrderFixture) {
  for (const WalkVelocity& v : {WalkVelocity{0.2, 0.1, 0.3}, WalkVelocity{-0.1, 0.2, -0.5}}) {
    const double least = sway_of(best(v), size, v, kPeriod, margin);
    WalkOrder order = {RR_, FR_, FL_, RL_};
    std::sort(order.begin(), order.end());
    do {
      BOOST_TEST(0.8 * least <= sway_of(order, size, v, kPeriod, margin) + 1e-12);
    } while (std::next_permutation(order.begin(), order.end()));
  }
}

// At rest all orders are equal.
BOOST_FIXTURE_TEST_CASE(order_is_kept_while_no_other_is_clearly_better, OrderFixture) {
  for (const WalkOrder& order : {kForward, kBackward, kLeft}) {
    BOOST_TEST((best({}, order) == order));
    BOOST_TEST((best({0.01, 0.0, 0.0}, order) == order));
  }
}

BOOST_AUTO_TEST_SUITE_END()
