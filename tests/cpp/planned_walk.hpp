// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/test/unit_test.hpp>
#include <optional>

#include "gait/walk_planner.hpp"
#include "pushed_robot.hpp"
#include "reference/planner_input.hpp"

namespace surefoot {

/// A walk planner, and a robot that does not move, whatever is planned.
struct PlannedWalk {
  static constexpr double kDt = 0.002, kDelay = 0.004;  // [s]

  Robot robot = quadruped();
  Gains gains;
  RobotState state = standing_state(robot);
  Dynamics dynamics = dynamics_at(robot, state);
  WalkPlanner planner{robot, 0.5};
  Reference reference;
  int lost_leg = -1;
  std::optional<FeetMatrix> p_feet;  ///< [m] contact points; default: those of the joint angles

  PlannedWalk() {
    state.contact.setOnes();
    run(0.32);  // the planner stands for 0.3 s
  }
  void tick() {
    PlannerInput input =
        make_planner_input(state, gains, dynamics, kDt, kDelay, robot.mass(), lost_leg);
    if (p_feet) input.p_feet = *p_feet;
    BOOST_REQUIRE(planner.plan(input, reference));
  }
  void run(double seconds) {
    for (int k = 0; k < seconds / kDt - 0.5; ++k) tick();
  }
  void walk(const WalkVelocity& velocity, double seconds) {
    for (int k = 0; k < seconds / kDt - 0.5; ++k) {
      planner.set_velocity(gains, velocity);
      tick();
    }
  }
  int swing_feet() const {
    int count = 0;
    for (const FootReference& foot : reference.feet) count += !foot.stance;
    return count;
  }
  void expect_standing_reference() const {
    BOOST_TEST(!planner.walking());
    BOOST_TEST(!reference.stepping);
    BOOST_TEST(reference.a_com.norm() == 0.0);
    for (const FootReference& foot : reference.feet) {
      BOOST_TEST((foot.stance && foot.load == 1.0 && foot.min_contact == 0.0));
      BOOST_TEST((foot.v_world.isZero(0.0) && foot.a_world.isZero(0.0)));
    }
  }
};

}  // namespace surefoot
