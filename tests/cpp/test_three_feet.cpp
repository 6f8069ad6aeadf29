// SPDX-License-Identifier: BSD-3-Clause
#include <boost/test/unit_test.hpp>

#include "reference/support_polygon.hpp"
#include "reference/three_feet.hpp"

using namespace surefoot;

namespace {

constexpr double kDt = 0.002;

struct Stance {
  FeetMatrix places;
  ThreeFeet three;
  Stance() {
    places << 0.19, 0.19, -0.19, -0.19,  //
        -0.13, 0.13, -0.13, 0.13,        //
        0.0, 0.0, 0.0, 0.0;
  }
  double margin_without(int leg, const Vector3& p) const {
    std::array<bool, kLegs> stance = {true, true, true, true};
    stance[leg] = false;
    return SupportPolygon(places, stance).margin(p.head<2>());
  }
  void wait(const Vector3& p_com) {
    for (int tick = 0; tick < 1000; ++tick) three.step(places, p_com, kDt);
  }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(three_feet)

BOOST_FIXTURE_TEST_CASE(on_all_four_it_asks_for_nothing, Stance) {
  wait(Vector3(0.05, 0.05, 0.3));
  BOOST_TEST(three.lean().isZero());
  BOOST_TEST(three.lost() == ThreeFeet::kNone);
}

BOOST_FIXTURE_TEST_CASE(it_leans_well_into_the_triangle_of_the_others_and_no_further, Stance) {
  for (int leg = 0; leg < kLegs; ++leg) {
    three.reset();
    three.give_up(leg);
    BOOST_TEST(std::abs(margin_without(leg, Vector3::Zero())) < 1e-9);
    wait(Vector3::Zero());
    BOOST_TEST(margin_without(leg, three.lean()) > 0.03);
    BOOST_TEST(three.lean().norm() < 0.06);
    BOOST_TEST(three.lean().z() == 0.0);
    BOOST_TEST(three.lost() == leg);
  }
}

BOOST_FIXTURE_TEST_CASE(a_body_that_is_over_three_feet_stays_there, Stance) {
  three.give_up(FL_);
  const Vector3 inside(-0.06, -0.05, 0.3);
  BOOST_TEST(margin_without(FL_, inside) > 0.05);
  wait(inside);
  BOOST_TEST(three.lean().norm() < 1e-9);
}

BOOST_FIXTURE_TEST_CASE(it_goes_there_smoothly, Stance) {
  three.give_up(RR_);
  Vector3 before = Vector3::Zero();
  for (int tick = 0; tick < 1000; ++tick) {
    three.step(places, Vector3::Zero(), kDt);
    BOOST_TEST((three.lean() - before).norm() < 0.001);
    before = three.lean();
  }
}

BOOST_AUTO_TEST_SUITE_END()
