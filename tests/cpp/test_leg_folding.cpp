// SPDX-License-Identifier: BSD-3-Clause
// How legs fold, and how a rise continues from the present pose.
#include <boost/test/unit_test.hpp>
#include <random>

#include "quadruped.hpp"
#include "supervisor/getting_up/folding/leg_folding.hpp"
#include "supervisor/getting_up/rise_motion.hpp"
#include "supervisor/getting_up/rise_plan.hpp"

using namespace surefoot;

namespace {

constexpr double kTick = 0.002;  // [s]
constexpr int kThigh = 1;        // of FR

/// Massless legs that follow their references; the thigh of FR turns back to `thigh_limit` only.
struct FoldingLegs {
  RisePlan plan = plan_rise(quadruped(), 50.0);
  LegFolding legs{plan, 2.0};
  Vector12 q = plan.standing;
  double lean = 0.0;         // [rad] roll of the body, right side down
  double thigh_limit = 1e9;  // [rad] limit of the thigh of FR

  Vector3 up() const { return {0.0, std::sin(lean), std::cos(lean)}; }
  const JointReference& step() {
    const JointReference& reference = legs.step(q, up(), kTick);
    q = reference.q;
    q[kThigh] = std::min(q[kThigh], thigh_limit);
    return reference;
  }
  /// Run until the legs are folded or stuck, at most `seconds`. @return elapsed time [s]
  double run(double seconds) {
    double time = 0.0;
    while (time < seconds && !legs.done() && !legs.stuck()) {
      step();
      time += kTick;
    }
    return time;
  }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(getting_up)

BOOST_FIXTURE_TEST_CASE(legs_fold_from_random_joint_angles, FoldingLegs) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  for (int trial = 0; trial < 50; ++trial) {
    for (int i = 0; i < kMotors; ++i) {
      q[i] = plan.lower[i] + share(random) * (plan.upper[i] - plan.lower[i]);
    }
    legs.start(q, up());
    BOOST_TEST(run(8.0) < 8.0);
    BOOST_TEST(legs.done());
    BOOST_TEST((q - plan.folded).cwiseAbs().maxCoeff() < 0.25);
  }
}

// Bent, the leg would lift the body while its hip opens.
BOOST_FIXTURE_TEST_CASE(leg_tucked_inward_is_extended_before_its_hip_abducts, FoldingLegs) {
  const double in = -plan.hip_outward_limit[0];
  q.head<3>() << in, -0.4, plan.lower[2];
  legs.start(q, up());
  while (std::abs(q[0] - in) < 0.05 && run(kTick) > 0.0) {
  }
  BOOST_TEST(q[kThigh] < plan.lower[kThigh] + 0.35);
  BOOST_TEST(q[2] > -1.55);
  run(8.0);
  BOOST_TEST(legs.done());
}

BOOST_FIXTURE_TEST_CASE(legs_are_released_and_extended_when_the_body_rolls, FoldingLegs) {
  const double in = -plan.hip_outward_limit[0];
  q.head<3>() << in, 1.2, plan.lower[2];
  legs.start(q, up());
  run(0.1);
  lean = 0.5;
  for (double time = 0.0; time < 1.0; time += kTick) {
    BOOST_TEST(legs.step(q, up(), kTick).dq.norm() == 0.0);  // q stays: the legs are released
    BOOST_TEST(!legs.done());
  }
  BOOST_TEST((legs.step(q, up(), kTick).q - q).cwiseAbs().maxCoeff() < 0.01);
  const double before = q[0];
  while (q[0] > before - 0.05 && run(kTick) > 0.0) {
  }
  BOOST_TEST(std::abs(q[kThigh] - 1.9) < 0.35);
  BOOST_TEST(q[2] > -1.55);
  run(8.0);  // the body still leans, but does not roll further
  BOOST_TEST(legs.done());
  BOOST_TEST(!legs.rolled_over());
}

BOOST_FIXTURE_TEST_CASE(repeated_rolls_are_reported_as_continued_rolling, FoldingLegs) {
  const Vector12 lying = q;
  legs.start(q, up());
  for (int roll = 0; roll < 2; ++roll) {
    run(0.1);
    BOOST_TEST((legs.step(q, up(), kTick).dq.norm() > 0.0));
    lean = 0.65;
    run(0.9);
    BOOST_TEST(legs.step(q, up(), kTick).dq.norm() == 0.0);  // released for 1 s
    lean = 0.0;
    run(0.2);
    BOOST_TEST(!legs.rolled_over());
  }
  lean = 0.6;  // the body leans, but does not roll over
  run(0.1);
  BOOST_TEST(!legs.rolled_over());
  legs.step(q, {-std::sin(0.72), 0.0, std::cos(0.72)}, kTick);  // nose up: no roll
  BOOST_TEST(!legs.rolled_over());
  for (const double side : {0.72, -0.72}) {
    LegFolding rolling = legs;
    rolling.step(q, {0.0, std::sin(side), std::cos(side)}, kTick);
    BOOST_TEST(rolling.rolled_over());
  }
  lean = 0.76;
  run(0.1);
  BOOST_TEST(legs.rolled_over());
  lean = 0.0;
  legs.start(q = lying, up());
  run(0.1);
  BOOST_TEST(!legs.rolled_over());
}

BOOST_FIXTURE_TEST_CASE(one_large_roll_is_reported_as_continued_rolling, FoldingLegs) {
  legs.start(q, up());
  run(0.1);
  lean = 0.6;
  run(0.1);
  BOOST_TEST(!legs.rolled_over());
  lean = 0.76;
  run(0.1);
  BOOST_TEST(legs.rolled_over());
}

BOOST_FIXTURE_TEST_CASE(side_folded_after_a_roll_is_reported, FoldingLegs) {
  const std::array<bool, kLegs> none = {}, left = {false, true, false, true};
  thigh_limit = 1.0;
  legs.set_wait(0.0);
  legs.start(q, up());
  run(0.1);
  lean = 0.5;
  run(0.1);
  lean = 0.0;
  run(1.0);  // the legs are released for 1 s
  BOOST_TEST((legs.folded_side(q) == none));
  run(4.0);
  BOOST_TEST((legs.folded_side(q) == left));
  LegFolding rolling = legs;
  rolling.step(q, {0.0, std::sin(0.6), std::cos(0.6)}, kTick);
  BOOST_TEST((rolling.folded_side(q) == none));  // folded, but released
  legs.side_weighed();
  BOOST_TEST((legs.folded_side(q) == none));  // none until a leg has caught again
}

BOOST_FIXTURE_TEST_CASE(folded_legs_refold_from_their_current_angles_after_a_roll, FoldingLegs) {
  legs.start(q, up());
  run(8.0);
  BOOST_TEST(legs.done());
  JointReference at{q, Vector12::Zero()};
  at.q[0] -= 0.2;  // as while they are weighed
  BOOST_TEST(!legs.detect_rollover(at, up(), kTick));
  BOOST_TEST(legs.done());
  lean = 0.5;
  BOOST_TEST(legs.detect_rollover(at, up(), kTick));
  BOOST_TEST((legs.step(q, up(), kTick).q - at.q).cwiseAbs().maxCoeff() < 0.02);
  BOOST_TEST(!legs.done());
  BOOST_TEST(!legs.rolled_over());
  lean = 0.76;
  BOOST_TEST(legs.detect_rollover(at, up(), kTick));
  BOOST_TEST(legs.rolled_over());
}

BOOST_FIXTURE_TEST_CASE(body_that_blocks_all_legs_is_pinned, FoldingLegs) {
  const Vector12 lying = q;
  const auto pinned = [&](int free, double leans, double until = 1.0) {
    q = lying;
    lean = 0.0;
    legs.start(q, up());
    lean = leans;
    for (double time = 0.0; time < 4.0; time += kTick) {
      if (time > until) lean = 0.0;
      const JointReference& reference = legs.step(q, up(), kTick);
      if (free >= 0) q.segment<3>(3 * free) = reference.q.segment<3>(3 * free);
    }
    return legs.pinned(q, up());
  };
  BOOST_TEST(pinned(-1, 0.0));
  q[3] += 0.5;  // a leg was moved and has caught elsewhere
  BOOST_TEST(!legs.pinned(q, up()));
  BOOST_TEST(!pinned(2, 0.0));        // one leg folds
  BOOST_TEST(!pinned(-1, 0.2, 9.0));  // the tilt of the body changes
  BOOST_TEST(!pinned(-1, 0.5));       // the body rolls, and the legs are released
}

// The legs fold in an order, but they are not released, which would take one more second.
BOOST_FIXTURE_TEST_CASE(body_that_leans_from_the_start_is_not_rolling, FoldingLegs) {
  const Vector12 lying = q;
  legs.start(q, up());
  const double upright = run(8.0);
  for (const double angle : {0.5, double(NAN)}) {
    q = lying;
    lean = std::isnan(angle) ? 0.0 : angle;
    legs.start(q, up());
    lean = angle;
    BOOST_TEST(run(8.0) <
               upright + (std::isnan(angle) ? 0.5 * kTick : std::min(upright, 2.0) + 0.1));
  }
}

// The diagonal pair that supports the lower side waits until the other pair is folded.
BOOST_FIXTURE_TEST_CASE(legs_of_a_leaning_body_fold_one_diagonal_pair_at_a_time, FoldingLegs) {
  const Vector12 standing = q;
  const double in = -plan.hip_outward_limit[FR_0];
  const auto waits = [&](double angle, double front_right_hip, double front_left_thigh) {
    q = standing;
    q[FR_0] = front_right_hip;
    q[FL_1] = front_left_thigh;
    lean = angle;
    const Vector12 before = q;
    legs.start(q, up());
    run(0.2);
    std::array<bool, kLegs> still = {};
    for (int leg = 0; leg < kLegs; ++leg) {
      still[leg] = (q - before).segment<kLegJoints>(kLegJoints * leg).norm() == 0.0;
    }
    run(8.0);
    BOOST_TEST(legs.done());
    return still;
  };
  const std::array<bool, kLegs> none = {}, right = {true, false, false, true},
                                left = {false, true, true, false};
  BOOST_TEST((waits(0.0, 0.0, 0.7) == none));
  BOOST_TEST((waits(0.3, 0.0, 0.7) == right));
  BOOST_TEST((waits(-0.3, 0.0, 0.7) == left));
  BOOST_TEST((waits(0.3, in, 0.7) == left));   // FR is under the body, FL supports it
  BOOST_TEST((waits(0.3, in, 2.3) == right));  // FL's foot is in the air
}

// The rear leg would turn the body over once the other legs are folded.
BOOST_FIXTURE_TEST_CASE(rear_leg_tucked_under_a_leaning_body_folds_first, FoldingLegs) {
  const Vector12 standing = q;
  const auto right_rear_waits = [&](double rr_hip, double rr_thigh, double rl_hip) {
    q = standing;
    q[RR_0] = rr_hip, q[RR_1] = rr_thigh, q[RL_0] = rl_hip;
    lean = -0.3;  // FL supports the body, and RR would wait with it
    const Vector3 before = q.segment<kLegJoints>(RR_0);
    legs.start(q, up());
    run(0.2);
    return q.segment<kLegJoints>(RR_0) == before;
  };
  const double right_in = -plan.hip_outward_limit[RR_0], left_in = -plan.hip_outward_limit[RL_0];
  BOOST_TEST(right_rear_waits(0.0, 0.7, 0.0));
  BOOST_TEST(!right_rear_waits(right_in, 0.7, 0.0));
  BOOST_TEST(right_rear_waits(right_in, 2.3, 0.0));      // its knee is up
  BOOST_TEST(right_rear_waits(right_in, 0.7, left_in));  // both rear legs are drawn in
}

// The detour time of a leg starts when the leg starts to fold.
BOOST_FIXTURE_TEST_CASE(leg_that_waited_is_still_extended_first, FoldingLegs) {
  const double in = -plan.hip_outward_limit[RR_0];
  q.segment<kLegJoints>(RR_0) << in, -0.4, plan.lower[RR_2];
  q[RL_0] = -plan.hip_outward_limit[RL_0];  // RL is drawn in too, or RR would fold first
  lean = -0.3;
  legs.set_wait(3.0);
  thigh_limit = plan.standing[kThigh] + 0.3;  // FR catches: others wait 3 s
  legs.start(q, up());
  run(2.9);
  BOOST_TEST(q[RR_0] == in);
  while (std::abs(q[RR_0] - in) < 0.05 && run(kTick) > 0.0) {
  }
  BOOST_TEST(q[RR_1] < plan.lower[RR_1] + 0.35);
  BOOST_TEST(q[RR_2] > -1.55);
}

BOOST_FIXTURE_TEST_CASE(all_legs_fold_at_once_without_a_wait, FoldingLegs) {
  const Vector12 standing = q;
  legs.set_wait(0.0);
  lean = 0.3;
  legs.start(q, up());
  run(0.2);
  for (int leg = 0; leg < kLegs; ++leg) {
    BOOST_TEST((q - standing).segment<kLegJoints>(kLegJoints * leg).norm() > 0.0);
  }
}

BOOST_FIXTURE_TEST_CASE(caught_leg_backs_out_and_retries, FoldingLegs) {
  legs.start(q, up());
  thigh_limit = plan.standing[kThigh] + 0.3;
  bool backed = false;
  for (double time = 0.0; time < 3.0; time += kTick) {
    step();
    backed = backed || q[kThigh] < thigh_limit - 0.25;
    if (backed) thigh_limit = 1e9;  // the leg comes free
  }
  BOOST_TEST(backed);
  run(8.0);
  BOOST_TEST(legs.done());
}

BOOST_FIXTURE_TEST_CASE(folded_side_is_reported_while_the_other_side_is_caught, FoldingLegs) {
  const std::array<bool, kLegs> none = {}, left = {false, true, false, true};
  thigh_limit = 1.0;
  legs.start(q, up());
  run(3.0);
  BOOST_TEST((legs.folded_side(q) == none));  // one catch is not enough
  run(9.0);
  BOOST_TEST((legs.folded_side(q) == left));
  thigh_limit = 1e9;  // FR comes free; it had caught, so only the left side can be reported
  run(20.0);
  const std::array<bool, kLegs> folded = legs.folded_side(q);
  BOOST_TEST(legs.done());
  BOOST_TEST(!folded[FR_]);
  BOOST_TEST(!folded[RR_]);
}

BOOST_FIXTURE_TEST_CASE(folding_stops_after_several_retries_of_a_caught_leg, FoldingLegs) {
  legs.start(q, up());
  thigh_limit = plan.standing[kThigh] + 0.3;
  int times = 0;
  bool out = false;
  double time = 0.0;
  for (; time < 60.0 && !legs.stuck(); time += kTick) {
    step();
    BOOST_TEST(!legs.done());
    const bool now = q[kThigh] < thigh_limit - 0.25;
    times += now && !out;
    out = now;
  }
  BOOST_TEST(times >= 5);
  BOOST_TEST(time > 15.0);
  BOOST_TEST(time < 45.0);
}

BOOST_AUTO_TEST_CASE(rise_path_parameter_is_recovered_from_joint_angles) {
  const RisePlan plan = plan_rise(quadruped(), 50.0);
  for (const double s : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    BOOST_TEST(plan.nearest(plan.joints_at(s)) == s);
    const Vector12 off = 0.1 * Vector12::LinSpaced(-1.0, 1.0);
    BOOST_TEST(std::abs(plan.nearest(plan.joints_at(s) + off) - s) < 0.1);
  }
}

BOOST_AUTO_TEST_CASE(height_motion_starts_smoothly_off_the_rise_path) {
  const RisePlan plan = plan_rise(quadruped(), 50.0);
  for (const double s : {0.3, 0.9, 1.0}) {
    const Vector12 off = 0.3 * Vector12::LinSpaced(-1.0, 1.0);
    RiseMotion motion(plan);
    motion.start(s, plan.joints_at(s) + off);
    motion.go_to(1.0);
    JointReference before{plan.joints_at(s) + off, Vector12::Zero()};
    double time = 0.0;
    for (; time < 5.0 && !motion.arrived(); time += kTick) {
      const JointReference now = motion.step(before.q, kTick);
      BOOST_TEST((now.q - before.q).cwiseAbs().maxCoeff() < 0.01);
      BOOST_TEST((now.dq - before.dq).cwiseAbs().maxCoeff() < 0.05);
      before = now;
    }
    BOOST_TEST(time < 5.0);
    BOOST_TEST((before.q - plan.standing).norm() < 1e-9);
  }
}

BOOST_AUTO_TEST_SUITE_END()
