// SPDX-License-Identifier: BSD-3-Clause
#include <boost/test/unit_test.hpp>

#include "supple.hpp"

using namespace surefoot;

BOOST_AUTO_TEST_SUITE(form_selector)

BOOST_FIXTURE_TEST_CASE(a_knee_that_straightens_changes_the_form_and_back_only_farther_away,
                        Supple) {
  double angle = -1.6;
  BOOST_TEST((judge() == Form::kCondensed));
  while (judge() == Form::kCondensed) set(FL_2, angle += 1e-4);
  BOOST_TEST(angle < 0.0);
  BOOST_TEST(std::abs(determinant() / smallest - 1.0) < 0.01);
  BOOST_TEST(selector.singular()[FL_]);
  BOOST_TEST(!selector.singular()[FR_]);
  while (judge() == Form::kGeneral) set(FL_2, angle -= 1e-4);
  BOOST_TEST(std::abs(determinant() / smallest - 1.2) < 0.01);
  BOOST_TEST(!selector.singular()[FL_]);
}

BOOST_FIXTURE_TEST_CASE(noise_on_a_knee_at_the_threshold_does_not_make_the_form_chatter, Supple) {
  double angle = -1.6;
  while (judge() == Form::kCondensed) set(FL_2, angle += 1e-4);
  for (int k = 0; k < 1000; ++k) {
    set(FL_2, angle + (k % 2 ? 1e-3 : -1e-3));
    BOOST_REQUIRE((judge() == Form::kGeneral));
  }
}

BOOST_FIXTURE_TEST_CASE(a_stance_foot_near_hip_height_is_singular_and_a_swing_foot_is_not, Supple) {
  double angle = 0.8;
  while (judge() == Form::kCondensed) set(FL_1, angle += 1e-4);
  const double depth = dynamics.legs()[FL_].depth;
  BOOST_TEST(std::abs(depth - 0.05) < 1e-3);
  BOOST_TEST(determinant() > 1.05 * smallest);  // it is the depth that decides
  while (judge() == Form::kGeneral) set(FL_1, angle -= 1e-4);
  BOOST_TEST(std::abs(dynamics.legs()[FL_].depth - 0.06) < 1e-3);
  reference.feet[FL_].stance = false;
  set(FL_1, angle + 0.05);
  BOOST_TEST((judge() == Form::kCondensed));
}

BOOST_FIXTURE_TEST_CASE(a_row_goes_soft_by_degrees_and_only_where_the_form_is_general, Supple) {
  double last = 0.0, softest = 0.0;
  for (double angle = -1.6; angle < 0.4; angle += 1e-3) {
    set(FL_2, angle);
    const Form form = judge();
    const double soft = selector.softness()[FL_];
    BOOST_REQUIRE((soft == 0.0 || form == Form::kGeneral));
    BOOST_REQUIRE(std::abs(soft - last) < 0.05);
    last = soft;
    softest = std::max(softest, soft);
  }
  BOOST_TEST(softest == 1.0);
  BOOST_TEST(selector.softness()[FR_] == 0.0);
}

BOOST_FIXTURE_TEST_CASE(a_form_asked_for_is_the_form_that_is_taken, Supple) {
  BOOST_TEST((judge(Form::kGeneral) == Form::kGeneral));
  set(FL_2, 0.0);
  BOOST_TEST((judge(Form::kCondensed) == Form::kCondensed));
  BOOST_TEST(selector.singular()[FL_]);
}

BOOST_AUTO_TEST_SUITE_END()
