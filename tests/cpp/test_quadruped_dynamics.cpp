// SPDX-License-Identifier: BSD-3-Clause
// Compare the generated dynamics with Pinocchio's algorithms.
#include <boost/test/unit_test.hpp>
#include <pinocchio/multibody.hpp>

#include "dynamics/dynamics.hpp"
#include "robot_states.hpp"

using namespace surefoot;

namespace {

// Return the inertia of a random box at a random pose.
pinocchio::Inertia random_inertia() {
  const Vector3 size = 0.1 * (Vector3::Random() + Vector3::Constant(1.5));
  pinocchio::SE3 pose = pinocchio::SE3::Random();
  pose.translation() *= 0.2;
  const double mass = 1.5 + Vector3::Random().x();
  return pose.act(pinocchio::Inertia::FromBox(mass, size.x(), size.y(), size.z()));
}

// Make a quadruped with the same joint layout but random lengths, masses and inertias.
pinocchio::Model randomised_model(int seed) {
  std::srand(seed);
  pinocchio::Model model = quadruped().model();
  for (int joint = 1; joint < model.njoints; ++joint) {
    model.inertias[joint] = random_inertia();
    if (joint > 1) model.jointPlacements[joint].translation() += 0.05 * Vector3::Random();
  }
  for (auto& frame : model.frames) {
    if (frame.type == pinocchio::BODY) frame.placement.translation() += 0.03 * Vector3::Random();
  }
  return model;
}

template <typename A, typename B>
bool same(const A& a, const B& b) {
  return (a - b).norm() <= 1e-11 * std::max(1.0, b.norm());
}

void check_legs(const Dynamics& generated, const Dynamics& pinocchio_dynamics) {
  for (int leg = 0; leg < kLegs; ++leg) {
    const LegDynamics &a = generated.legs()[leg], &b = pinocchio_dynamics.legs()[leg];
    BOOST_TEST(same(a.p_world_contact, b.p_world_contact));
    BOOST_TEST(same(a.v_world_contact, b.v_world_contact));
    BOOST_TEST(same(a.w_world_shank, b.w_world_shank));
    BOOST_TEST(same(a.joint_axes_world, b.joint_axes_world));
    BOOST_TEST(same(a.J_base, b.J_base));
    BOOST_TEST(same(a.J_leg, b.J_leg));
    BOOST_TEST(same(a.drift, b.drift));
    BOOST_TEST(same(a.M_base_leg, b.M_base_leg));
    BOOST_TEST(same(a.M_leg, b.M_leg));
    BOOST_TEST(same(a.h_leg, b.h_leg));
    BOOST_TEST(std::abs(a.depth - b.depth) < 1e-11);
  }
}

void check_base(const Dynamics& generated, const Dynamics& pinocchio_dynamics) {
  BOOST_TEST(same(generated.M_base(), pinocchio_dynamics.M_base()));
  BOOST_TEST(same(generated.h_base(), pinocchio_dynamics.h_base()));
  BOOST_TEST(same(generated.R_world_base(), pinocchio_dynamics.R_world_base()));
  BOOST_TEST(same(generated.I_world_com(), pinocchio_dynamics.I_world_com()));
  BOOST_TEST(same(generated.p_world_com(), pinocchio_dynamics.p_world_com()));
  BOOST_TEST(same(generated.v_world_com(), pinocchio_dynamics.v_world_com()));
  BOOST_TEST(same(generated.L_world_com(), pinocchio_dynamics.L_world_com()));
  BOOST_TEST(same(generated.p_world_base(), pinocchio_dynamics.p_world_base()));
  BOOST_TEST(same(generated.v_world_base(), pinocchio_dynamics.v_world_base()));
  BOOST_TEST(same(generated.v_base(), pinocchio_dynamics.v_base()));
  BOOST_TEST(same(generated.w_base(), pinocchio_dynamics.w_base()));
}

void check_full(const Robot& robot, const Dynamics& generated, const Dynamics& pinocchio_dynamics) {
  FullDynamics a(robot.nv()), b(robot.nv());
  generated.write_full(a);
  pinocchio_dynamics.write_full(b);
  BOOST_TEST(same(a.M, b.M));
  BOOST_TEST(same(a.h, b.h));
  BOOST_TEST(same(a.J, b.J));
}

}  // namespace

BOOST_AUTO_TEST_SUITE(quadruped_dynamics)

BOOST_AUTO_TEST_CASE(generated_code_matches_pinocchio_on_random_quadrupeds) {
  for (int seed = 1; seed <= 20; ++seed) {
    const Robot robot(randomised_model(seed), quadruped_config());
    Dynamics generated(robot), pinocchio_dynamics(robot, Dynamics::Source::kPinocchio);
    BOOST_REQUIRE(generated.uses_generated_code());
    BOOST_REQUIRE(!pinocchio_dynamics.uses_generated_code());
    for (int k = 0; k < 10; ++k) {
      const RobotState state = random_state(robot, 100 * seed + k, 3.0);
      const Vector3 normal = (Vector3::UnitZ() + 0.3 * Vector3::Random()).normalized();
      for (Dynamics* d : {&generated, &pinocchio_dynamics}) {
        d->update(state.q, state.v, normal);
        d->shift(Vector3(0.3, -0.2, 0.1), Vector3(-0.5, 0.4, 0.2));
      }
      check_legs(generated, pinocchio_dynamics);
      check_base(generated, pinocchio_dynamics);
      check_full(robot, generated, pinocchio_dynamics);
    }
  }
}

BOOST_AUTO_TEST_CASE(robot_with_another_joint_layout_uses_pinocchio) {
  BOOST_TEST(!Dynamics(quadruped_with_arm()).uses_generated_code());
  pinocchio::Model turned = quadruped().model();
  turned.jointPlacements[4].rotation() =
      Eigen::AngleAxisd(0.01, Vector3::UnitZ()).toRotationMatrix();
  BOOST_TEST(!Dynamics(Robot(turned, quadruped_config())).uses_generated_code());
}

BOOST_AUTO_TEST_SUITE_END()
