// SPDX-License-Identifier: BSD-3-Clause
#include <boost/test/unit_test.hpp>

#include "leaning.hpp"
#include "reference/capture_margin.hpp"
#include "wbc/usable_friction.hpp"

using namespace surefoot;

namespace {

constexpr double kCalm = 0.7, kEdge = 0.06;

struct Using : Leaning {
  Eigen::Vector4d share() const {
    return usable_friction(dynamics, state, reference, robot.mass());
  }
  // Leans until the capture point is so far inside the left edge.
  void lean_to(double margin) {
    const double edge = contact_points(robot, state.q)(1, FL_);
    lean(Vector3(0.0, (edge - margin - dynamics.p_world_com().y()) * omega(), 0.0));
  }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(friction_in_use)

BOOST_FIXTURE_TEST_CASE(the_last_third_is_for_the_edge, Using) {
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
  BOOST_TEST((share() - kCalm * state.friction).cwiseAbs().maxCoeff() < 1e-12);
}

// Tasks may ask for what they like: no foot is asked for more than it may use.
BOOST_FIXTURE_TEST_CASE(forces_stay_inside, Using) {
  for (const double margin : {0.1, 0.02, -0.02}) {
    lean_to(margin);
    WholeBodyController controller(robot, gains, {Form::kCondensed});
    Reference r = controller.hold(state);
    r.a_com.y() = -30.0;
    const Solution& s = controller.update(state, r);
    BOOST_REQUIRE(is_usable(s.status));
    const Eigen::Vector4d most = robot.config().friction * share();
    for (int leg = 0; leg < kLegs; ++leg) {
      const Vector3 f = s.forces.col(leg);
      BOOST_TEST(f.head<2>().norm() < most[leg] * f.z() + 0.05);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
