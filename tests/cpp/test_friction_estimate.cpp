// SPDX-License-Identifier: BSD-3-Clause
// Friction coefficient learnt from synthetic feet that slide, hold, land and sink.
#include <boost/test/unit_test.hpp>

#include "estimator/contact/friction_estimate.hpp"
#include "quadruped.hpp"

using namespace surefoot;

namespace {

constexpr double kPeriod = 0.002;

// Four loaded feet, one of which, FL, moves or carries a tangential force.
struct FrictionFixture {
  Robot robot = quadruped();
  FrictionEstimate friction{robot};
  double weight = robot.mass() * kGravity;
  FeetMatrix v = FeetMatrix::Zero(), forces = FeetMatrix::Zero();
  Eigen::Vector4d contact = Eigen::Vector4d::Ones();
  Vector3 normal = Vector3::UnitZ();
  double v_error = 0.6, travelled = 0.0;
  bool stepping = false;

  FrictionFixture() {
    forces.row(2).setConstant(0.25 * weight);
    run(0.1);  // longer than the settling time
  }
  double assumed() const { return robot.config().friction; }
  double run(double seconds) {
    for (int k = 0; k < seconds / kPeriod - 0.5; ++k) {
      friction.update({v, forces, contact, normal, v_error, travelled, stepping}, kPeriod);
    }
    return friction.coefficient();
  }
  // FL carries `ratio` times its normal force backwards and moves forwards with `speed` [m/s].
  double slide(double ratio, double speed, double seconds) {
    forces(0, FL_) = -ratio * forces(2, FL_);
    v(0, FL_) = speed;
    return run(seconds);
  }
  double hold(double ratio, double seconds) { return slide(ratio, 0.0, seconds); }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(friction_estimate)

BOOST_FIXTURE_TEST_CASE(friction_of_the_ground_is_assumed_until_a_foot_slides, FrictionFixture) {
  BOOST_TEST(friction.coefficient() == assumed());
  BOOST_TEST(friction.usable_share() == 1.0);
  BOOST_TEST(friction.at_limit().isZero());
  BOOST_TEST(hold(0.3, 1.0) == assumed());
  BOOST_TEST(hold(0.9, 1.0) == assumed());  // never more than the robot's file says
}

BOOST_FIXTURE_TEST_CASE(sliding_foot_teaches_the_ratio_of_its_forces, FrictionFixture) {
  for (const double ratio : {0.2, 0.3, 0.4}) {
    friction.reset();
    hold(0.0, 0.1);
    BOOST_TEST(std::abs(slide(ratio, 0.5, 0.1) - ratio) < 0.05);
    const double usable = friction.usable_share() * assumed();
    BOOST_TEST(usable < 0.95 * friction.coefficient());
    BOOST_TEST(usable > 0.89 * friction.coefficient());
    BOOST_TEST(friction.at_limit()[FL_] > 0.5);
    BOOST_TEST(friction.at_limit()[FR_] == 0.0);
  }
  BOOST_TEST(slide(0.01, 0.5, 1.0) == 0.1);  // the least coefficient
}

BOOST_FIXTURE_TEST_CASE(a_few_millimetres_of_sliding_suffice, FrictionFixture) {
  BOOST_TEST(slide(0.3, 0.3, 0.02) <
             0.5 * (assumed() + 0.3));  // 6 mm under a quarter of the weight
}

BOOST_FIXTURE_TEST_CASE(sliding_on_a_slope_counts_along_the_ground, FrictionFixture) {
  const double slope = 0.3;
  normal = Vector3(-std::sin(slope), 0.0, std::cos(slope));
  const Vector3 downhill(-std::cos(slope), 0.0, -std::sin(slope));
  forces = 0.25 * weight * normal.replicate<1, kLegs>();
  run(0.1);
  forces.col(FL_) -= 0.3 * 0.25 * weight * downhill;
  v.col(FL_) = 0.5 * downhill;
  BOOST_TEST(std::abs(run(0.1) - 0.3) < 0.05);
}

BOOST_FIXTURE_TEST_CASE(force_that_does_not_oppose_the_motion_is_no_friction, FrictionFixture) {
  BOOST_TEST(slide(-0.2, 0.5, 0.5) == assumed());  // it drives the foot
  forces(0, FL_) = 0.0;
  forces(1, FL_) = 0.2 * forces(2, FL_);  // across the motion
  BOOST_TEST(run(0.5) == assumed());
}

BOOST_FIXTURE_TEST_CASE(speed_that_all_feet_have_in_common_is_no_sliding, FrictionFixture) {
  forces.row(0) = -0.2 * forces.row(2);
  v.row(0).setConstant(0.5);
  BOOST_TEST(run(0.5) == assumed());
  v(0, FL_) = 1.0;
  BOOST_TEST(run(0.1) < 0.25);
}

BOOST_FIXTURE_TEST_CASE(common_speed_beyond_the_possible_error_of_the_base_is_sliding,
                        FrictionFixture) {
  v_error = 0.05;
  forces.row(0) = -0.2 * forces.row(2);
  v.row(0).setConstant(0.3);
  BOOST_TEST(run(0.05) < 0.25);
}

BOOST_FIXTURE_TEST_CASE(slow_feet_with_little_load_show_that_the_loaded_feet_slide,
                        FrictionFixture) {
  forces.row(2) << 0.45 * weight, 0.45 * weight, 0.05 * weight, 0.05 * weight;
  forces.row(0) = -0.3 * forces.row(2);
  v.row(0) << 0.4, 0.4, 0.1, 0.1;
  BOOST_TEST(run(0.05) < 0.35);
}

BOOST_FIXTURE_TEST_CASE(faded_memory_of_a_slide_is_no_limit, FrictionFixture) {
  slide(0.3, 0.5, 0.1);
  hold(0.3, 0.002);
  BOOST_TEST(friction.at_limit()[FL_] > 0.9);
  travelled = 1.0;  // in each tick: 4 km in all, where the memories underflow
  hold(0.3, 8.0);
  BOOST_TEST(friction.at_limit()[FL_] == 0.0);
  BOOST_TEST(friction.coefficient() == assumed());
}

BOOST_FIXTURE_TEST_CASE(only_a_foot_whose_force_opposes_its_motion_slides, FrictionFixture) {
  slide(0.2, 0.5, 0.1);
  BOOST_TEST(friction.slides()[FL_]);
  BOOST_TEST(!friction.slides()[FR_]);
  slide(-0.2, 0.5, 0.1);
  BOOST_TEST(!friction.slides()[FL_]);
  slide(0.05, 0.5, 0.1);
  BOOST_TEST(!friction.slides()[FL_]);
}

BOOST_FIXTURE_TEST_CASE(unloaded_slow_or_sinking_foot_does_not_slide, FrictionFixture) {
  BOOST_TEST(slide(0.2, 0.02, 1.0) == assumed());
  v.setZero();
  v(2, FL_) = -0.5;
  BOOST_TEST(run(1.0) == assumed());
  forces.col(FL_) *= 0.2;
  BOOST_TEST(slide(0.2, 0.5, 1.0) == assumed());
}

BOOST_FIXTURE_TEST_CASE(landing_foot_counts_after_its_first_40_ms, FrictionFixture) {
  contact[FL_] = 0.0;
  slide(0.2, 0.5, 0.1);
  BOOST_TEST(friction.coefficient() == assumed());
  contact[FL_] = 1.0;
  BOOST_TEST(run(0.038) == assumed());
  BOOST_TEST(run(0.03) < 0.5 * (assumed() + 0.2));
}

BOOST_FIXTURE_TEST_CASE(soft_sole_of_a_stepping_robot_may_move_a_little, FrictionFixture) {
  stepping = true;
  run(0.002);
  BOOST_TEST(slide(0.2, 0.08, 1.0) == assumed());
  stepping = false;
  BOOST_TEST(run(0.2) < 0.4);
}

BOOST_FIXTURE_TEST_CASE(ratio_that_has_held_outweighs_a_short_contradicting_slide,
                        FrictionFixture) {
  hold(0.5, 0.5);
  BOOST_TEST(slide(0.1, 0.2, 0.01) == assumed());  // 2 mm
  BOOST_TEST(slide(0.1, 0.5, 0.2) < 0.25);         // the ground has changed
}

BOOST_FIXTURE_TEST_CASE(ratio_that_holds_raises_a_coefficient_that_was_learnt, FrictionFixture) {
  BOOST_TEST(slide(0.2, 0.5, 0.2) < 0.25);
  BOOST_TEST(std::abs(hold(0.4, 0.5) - 0.4) < 0.01);
}

BOOST_FIXTURE_TEST_CASE(learnt_friction_fades_with_the_distance_travelled_not_with_time,
                        FrictionFixture) {
  const double learnt = slide(0.2, 0.5, 0.1);
  hold(0.0, 60.0);
  BOOST_TEST(std::abs(friction.coefficient() - learnt) < 1e-9);
  travelled = 0.5 * kPeriod;  // 0.5 m/s
  BOOST_TEST(run(2.0) < 0.35);
  BOOST_TEST(run(60.0) > 0.95 * assumed());
}

BOOST_AUTO_TEST_SUITE_END()
