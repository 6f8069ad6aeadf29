// SPDX-License-Identifier: BSD-3-Clause
// Feet without load are held more stiffly than their gains.
#include <boost/test/unit_test.hpp>

#include "quadruped.hpp"
#include "robot_states.hpp"
#include "tick/unloaded_feet.hpp"

using namespace surefoot;

namespace {

// RR is displaced from its reference position; all feet are at rest.
struct DisplacedFoot {
  Robot robot = quadruped();
  RobotState state = standing_state(robot);
  Dynamics dynamics{robot};
  Reference reference;
  Vector3 offset = Vector3(0.004, -0.003, 0.0);

  DisplacedFoot() {
    dynamics.update(state.q, state.v, Vector3::UnitZ());
    reference = reference_at(robot, state);
    reference.feet[RR_].p_world += offset;
  }
  Vector3 hold(double load) const {
    const Eigen::Vector4d loads(0.3, 0.3, load, 0.3);
    const FeetMatrix all = unloaded_feet_hold(Gains(), dynamics, state, reference, loads);
    BOOST_TEST((all.array() == 0.0).count() >= 9);  // only RR
    return all.col(RR_);
  }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(unloaded_feet)

BOOST_FIXTURE_TEST_CASE(hold_grows_from_a_tenth_of_the_weight_to_no_load, DisplacedFoot) {
  BOOST_TEST(hold(0.1).isZero());
  BOOST_TEST(hold(0.25).isZero());
  BOOST_TEST((hold(0.0) - (4900.0 - Gains().foot_kp) * offset).norm() < 1e-6);
  BOOST_TEST((hold(0.05) - 0.5 * hold(0.0)).norm() < 1e-9);
}

BOOST_FIXTURE_TEST_CASE(hold_is_limited, DisplacedFoot) {
  reference.feet[RR_].p_world += 100.0 * offset;
  BOOST_TEST(std::abs(hold(0.0).norm() - 50.0) < 1e-9);
}

BOOST_FIXTURE_TEST_CASE(lifted_foot_swing_foot_and_stepping_robot_are_not_held, DisplacedFoot) {
  state.contact[RR_] = 0.3;
  const Vector3 partly = hold(0.0);
  state.contact[RR_] = 1.0;
  BOOST_TEST((partly - 0.3 * hold(0.0)).norm() < 1e-9);
  state.contact[RR_] = 0.0;
  BOOST_TEST(hold(0.0).isZero());
  state.contact[RR_] = 1.0;
  reference.feet[RR_].stance = false;
  BOOST_TEST(hold(0.0).isZero());
  reference.feet[RR_].stance = true;
  reference.stepping = true;
  BOOST_TEST(hold(0.0).isZero());
}

BOOST_AUTO_TEST_SUITE_END()
