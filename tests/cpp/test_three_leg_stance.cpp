// SPDX-License-Identifier: BSD-3-Clause
#include <boost/test/unit_test.hpp>

#include "reference/support_polygon.hpp"
#include "reference/three_leg_stance.hpp"

using namespace surefoot;

namespace {

constexpr double kDt = 0.002;

struct ThreeLegStanceFixture {
  FeetMatrix places;
  ThreeLegStance three;
  ThreeLegStanceFixture() {
    places << 0.19, 0.19, -0.19, -0.19,  //
        -0.13, 0.13, -0.13, 0.13,        //
        0.0, 0.0, 0.0, 0.0;
  }
  double capture_margin_without(int leg, const Vector3& p) const {
    std::array<bool, kLegs> stance = {true, true, true, true};
    stance[leg] = false;
    return SupportPolygon(places, stance).margin(p.head<2>());
  }
  void wait(int lost_leg, const Vector3& p_com) {
    for (int tick = 0; tick < 1000; ++tick) three.update(lost_leg, places, p_com, kDt);
  }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(three_leg_stance)

BOOST_FIXTURE_TEST_CASE(lean_is_zero_on_four_legs, ThreeLegStanceFixture) {
  wait(-1, Vector3(0.05, 0.05, 0.3));
  BOOST_TEST(three.com_offset().isZero());
}

BOOST_FIXTURE_TEST_CASE(body_leans_at_most_6_cm_into_the_support_triangle, ThreeLegStanceFixture) {
  for (int leg = 0; leg < kLegs; ++leg) {
    three.reset();
    BOOST_TEST(std::abs(capture_margin_without(leg, Vector3::Zero())) < 1e-9);
    wait(leg, Vector3::Zero());
    BOOST_TEST(capture_margin_without(leg, three.com_offset()) > 0.03);
    BOOST_TEST(three.com_offset().norm() < 0.06);
    BOOST_TEST(three.com_offset().z() == 0.0);
  }
}

BOOST_FIXTURE_TEST_CASE(body_over_the_support_triangle_does_not_lean, ThreeLegStanceFixture) {
  const Vector3 inside(-0.06, -0.05, 0.3);
  BOOST_TEST(capture_margin_without(FL_, inside) > 0.05);
  wait(FL_, inside);
  BOOST_TEST(three.com_offset().norm() < 1e-9);
}

BOOST_FIXTURE_TEST_CASE(lean_changes_smoothly, ThreeLegStanceFixture) {
  Vector3 before = Vector3::Zero();
  for (int tick = 0; tick < 1000; ++tick) {
    three.update(RR_, places, Vector3::Zero(), kDt);
    BOOST_TEST((three.com_offset() - before).norm() < 0.001);
    before = three.com_offset();
  }
}

BOOST_AUTO_TEST_SUITE_END()
