// SPDX-License-Identifier: BSD-3-Clause
#include <boost/test/unit_test.hpp>

#include "dynamics/dynamics.hpp"
#include "scenes.hpp"

using namespace surefoot;

namespace {

// Of the greater one's size, or of a thousandth.
template <typename A, typename B>
double difference(const A& a, const B& b) {
  return (a - b).norm() / std::max(1e-3, b.norm());
}

double worst_difference(const Dynamics& a, const Dynamics& b) {
  double worst = 0.0;
  const auto compare = [&worst](const auto& x, const auto& y) {
    worst = std::max(worst, difference(x, y));
  };
  compare(a.M_base(), b.M_base());
  compare(a.h_base(), b.h_base());
  compare(a.I_world_com(), b.I_world_com());
  compare(a.R_world_base(), b.R_world_base());
  compare(a.p_world_com(), b.p_world_com());
  compare(a.v_world_com(), b.v_world_com());
  compare(a.L_world_com(), b.L_world_com());
  compare(a.p_world_base(), b.p_world_base());
  compare(a.v_world_base(), b.v_world_base());
  for (int leg = 0; leg < kLegs; ++leg) {
    const LegDynamics &x = a.legs()[leg], &y = b.legs()[leg];
    compare(x.J_base, y.J_base);
    compare(x.J_leg, y.J_leg);
    compare(x.drift, y.drift);
    compare(x.M_leg, y.M_leg);
    compare(x.M_base_leg, y.M_base_leg);
    compare(x.h_leg, y.h_leg);
    compare(x.p_world_contact, y.p_world_contact);
    compare(x.v_world_contact, y.v_world_contact);
    worst = std::max(worst, std::abs(x.depth - y.depth));
  }
  return worst;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(quadruped_dynamics)

BOOST_AUTO_TEST_CASE(generated_code_and_pinocchio_agree) {
  const Robot robot = quadruped();
  Dynamics generated(robot), pinocchio(robot, Dynamics::Source::kPinocchio);
  BOOST_TEST(generated.generated());
  BOOST_TEST(!pinocchio.generated());
  FullDynamics a(robot.nv()), b(robot.nv());
  for (int seed = 0; seed < 500; ++seed) {
    const RobotState state = random_state(robot, seed, 3.0);
    const Vector3 normal = (Vector3::UnitZ() + 0.3 * Vector3::Random()).normalized();
    generated.update(state.q, state.v, normal);
    pinocchio.update(state.q, state.v, normal);
    BOOST_REQUIRE(worst_difference(generated, pinocchio) < 1e-11);
    generated.write_full(a);
    pinocchio.write_full(b);
    BOOST_TEST(difference(a.M, b.M) < 1e-11);
    BOOST_TEST(difference(a.h, b.h) < 1e-11);
    BOOST_TEST(difference(a.J, b.J) < 1e-11);
  }
}

BOOST_AUTO_TEST_CASE(a_robot_of_another_shape_is_pinocchios) {
  BOOST_TEST(!Dynamics(quadruped_with_arm()).generated());
}

BOOST_AUTO_TEST_SUITE_END()
