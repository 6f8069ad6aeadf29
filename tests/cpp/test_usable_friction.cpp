// SPDX-License-Identifier: BSD-3-Clause
#include <boost/test/unit_test.hpp>

#include "leaning.hpp"
#include "reference/capture_margin.hpp"
#include "reference/usable_friction.hpp"

using namespace surefoot;

namespace {

constexpr double kCalm = 0.7, kEdge = 0.06;

struct Using : Leaning {
  // Where it comes to rest.
  Eigen::Vector4d share() {
    UsableFriction friction;
    friction.update(dynamics, state, reference, robot.mass(), 1.0);
    return friction.update(dynamics, state, reference, robot.mass(), 1.0);
  }
  // Leans until the capture point is so far inside the left edge.
  void lean_to(double margin) {
    const double edge = contact_points(robot, state.q)(1, FL_);
    lean(Vector3(0.0, (edge - margin - dynamics.p_world_com().y()) * omega(), 0.0));
  }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(friction_in_use)

BOOST_FIXTURE_TEST_CASE(three_tenths_are_for_the_edge, Using) {
  BOOST_TEST((share().array() - kCalm).abs().maxCoeff() < 1e-12);
  for (const double margin : {0.1, kEdge, 0.03, 0.0, -0.05}) {
    lean_to(margin);
    const double calm = std::min(std::max(margin / kEdge, 0.0), 1.0);
    BOOST_TEST((share().array() - (1.0 - calm * (1.0 - kCalm))).abs().maxCoeff() < 1e-9);
  }
}

// A push that will take it there is met before the body moves.
BOOST_FIXTURE_TEST_CASE(a_push_counts_by_what_it_will_have_done, Using) {
  const double inside = capture_margin(dynamics, reference);
  const double enough = inside * omega() * robot.mass() / 0.1;  // [N] for a tenth of a second
  state.f_outside.y() = 0.2 * enough;
  BOOST_TEST((share().array() - kCalm).abs().maxCoeff() < 1e-12);
  state.f_outside.y() = enough;
  BOOST_TEST((share().array() - 1.0).abs().maxCoeff() < 1e-9);
}

BOOST_FIXTURE_TEST_CASE(feet_that_slip_use_what_is_left, Using) {
  state.friction << 1.0, 0.5, 0.0, 1.0;
  BOOST_TEST((share() - Eigen::Vector4d(kCalm, 0.5, 0.0, kCalm)).cwiseAbs().maxCoeff() < 1e-12);
}

// The end of a push reads as a push the other way.
BOOST_FIXTURE_TEST_CASE(what_pushes_inwards_takes_nothing_away, Using) {
  lean_to(0.0);
  state.f_outside.y() = -20.0 * robot.mass();
  BOOST_TEST((share().array() - 1.0).abs().maxCoeff() < 1e-9);
}

BOOST_FIXTURE_TEST_CASE(two_feet_use_all_of_it, Using) {
  reference.feet[FR_].load = reference.feet[RL_].load = 0.0;
  BOOST_TEST((share().array() - 1.0).abs().maxCoeff() == 0.0);
}

BOOST_FIXTURE_TEST_CASE(it_is_given_at_once_and_taken_back_in_a_tenth_of_a_second, Using) {
  UsableFriction friction;
  const auto tick = [&] {
    return friction.update(dynamics, state, reference, robot.mass(), 0.002)[0];
  };
  for (int k = 1; k <= 60; ++k)
    BOOST_TEST(std::abs(tick() - std::max(1.0 - 0.006 * k, kCalm)) < 1e-9);
  lean_to(0.0);
  BOOST_TEST(std::abs(tick() - 1.0) < 1e-9);
}

BOOST_AUTO_TEST_SUITE_END()
