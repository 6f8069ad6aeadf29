// SPDX-License-Identifier: BSD-3-Clause
// The generated dynamics against Pinocchio's algorithms.
#include <boost/test/unit_test.hpp>
#include <pinocchio/multibody.hpp>

#include "dynamics/dynamics.hpp"
#include "scenes.hpp"

using namespace surefoot;

namespace {

// A quadruped of the shape, none of whose lengths, masses and inertias is like another's.
pinocchio::Model odd_model(int seed) {
  std::srand(seed);
  pinocchio::Model model = quadruped().model();
  for (int joint = 1; joint < model.njoints; ++joint) {
    model.inertias[joint] = pinocchio::Inertia::Random();
    if (joint > 1) model.jointPlacements[joint].translation() += 0.1 * Vector3::Random();
  }
  for (auto& frame : model.frames) {
    if (frame.type == pinocchio::BODY) frame.placement.translation() += 0.05 * Vector3::Random();
  }
  return model;
}

template <typename A, typename B>
bool same(const A& a, const B& b) {
  return (a - b).norm() <= 1e-11 * std::max(1.0, b.norm());
}

void check_legs(const Dynamics& ours, const Dynamics& theirs) {
  for (int leg = 0; leg < kLegs; ++leg) {
    const LegDynamics &a = ours.legs()[leg], &b = theirs.legs()[leg];
    BOOST_TEST(same(a.p_world_contact, b.p_world_contact));
    BOOST_TEST(same(a.v_world_contact, b.v_world_contact));
    BOOST_TEST(same(a.w_world_shank, b.w_world_shank));
    BOOST_TEST(same(a.axes_world, b.axes_world));
    BOOST_TEST(same(a.J_base, b.J_base));
    BOOST_TEST(same(a.J_leg, b.J_leg));
    BOOST_TEST(same(a.drift, b.drift));
    BOOST_TEST(same(a.M_base_leg, b.M_base_leg));
    BOOST_TEST(same(a.M_leg, b.M_leg));
    BOOST_TEST(same(a.h_leg, b.h_leg));
    BOOST_TEST(std::abs(a.depth - b.depth) < 1e-11);
  }
}

void check_base(const Dynamics& ours, const Dynamics& theirs) {
  BOOST_TEST(same(ours.M_base(), theirs.M_base()));
  BOOST_TEST(same(ours.h_base(), theirs.h_base()));
  BOOST_TEST(same(ours.R_world_base(), theirs.R_world_base()));
  BOOST_TEST(same(ours.I_world_com(), theirs.I_world_com()));
  BOOST_TEST(same(ours.p_world_com(), theirs.p_world_com()));
  BOOST_TEST(same(ours.v_world_com(), theirs.v_world_com()));
  BOOST_TEST(same(ours.L_world_com(), theirs.L_world_com()));
  BOOST_TEST(same(ours.p_world_base(), theirs.p_world_base()));
  BOOST_TEST(same(ours.v_world_base(), theirs.v_world_base()));
  BOOST_TEST(same(ours.v_base(), theirs.v_base()));
  BOOST_TEST(same(ours.w_base(), theirs.w_base()));
}

void check_full(const Robot& robot, const Dynamics& ours, const Dynamics& theirs) {
  FullDynamics a(robot.nv()), b(robot.nv());
  ours.write_full(a);
  theirs.write_full(b);
  BOOST_TEST(same(a.M, b.M));
  BOOST_TEST(same(a.h, b.h));
  BOOST_TEST(same(a.J, b.J));
}

}  // namespace

BOOST_AUTO_TEST_SUITE(quadruped_dynamics)

BOOST_AUTO_TEST_CASE(generated_code_and_pinocchio_agree_on_any_robot_of_the_shape) {
  for (int seed = 1; seed <= 20; ++seed) {
    const Robot robot(odd_model(seed), quadruped_config());
    Dynamics ours(robot), theirs(robot, Dynamics::Source::kPinocchio);
    BOOST_REQUIRE(ours.generated());
    BOOST_REQUIRE(!theirs.generated());
    for (int k = 0; k < 10; ++k) {
      const RobotState state = random_state(robot, 100 * seed + k, 3.0);
      const Vector3 normal = (Vector3::UnitZ() + 0.3 * Vector3::Random()).normalized();
      for (Dynamics* d : {&ours, &theirs}) {
        d->update(state.q, state.v, normal);
        d->shift(Vector3(0.3, -0.2, 0.1), Vector3(-0.5, 0.4, 0.2));
      }
      check_legs(ours, theirs);
      check_base(ours, theirs);
      check_full(robot, ours, theirs);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_robot_of_another_shape_stays_on_pinocchio) {
  BOOST_TEST(!Dynamics(quadruped_with_arm()).generated());
  pinocchio::Model turned = quadruped().model();
  turned.jointPlacements[4].rotation() =
      Eigen::AngleAxisd(0.01, Vector3::UnitZ()).toRotationMatrix();
  BOOST_TEST(!Dynamics(Robot(turned, quadruped_config())).generated());
}

BOOST_AUTO_TEST_SUITE_END()
