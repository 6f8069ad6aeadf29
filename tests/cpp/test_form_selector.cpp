// SPDX-License-Identifier: BSD-3-Clause
#include <boost/test/unit_test.hpp>

#include "wide_range_quadruped.hpp"

using namespace surefoot;

BOOST_AUTO_TEST_SUITE(form_selector)

BOOST_FIXTURE_TEST_CASE(straightening_knee_switches_the_form_with_hysteresis, WideRangeRobot) {
  double angle = -1.6;
  BOOST_TEST((select_form() == QpForm::kCondensed));
  while (select_form() == QpForm::kCondensed) set(FL_2, angle += 1e-4);
  BOOST_TEST(angle < 0.0);
  BOOST_TEST(std::abs(determinant() / min_determinant - 1.0) < 0.01);
  BOOST_TEST(selector.singular()[FL_]);
  BOOST_TEST(!selector.singular()[FR_]);
  while (select_form() == QpForm::kGeneral) set(FL_2, angle -= 1e-4);
  BOOST_TEST(std::abs(determinant() / min_determinant - 1.2) < 0.01);
  BOOST_TEST(!selector.singular()[FL_]);
}

BOOST_FIXTURE_TEST_CASE(noise_on_a_knee_at_the_threshold_does_not_make_the_form_chatter,
                        WideRangeRobot) {
  double angle = -1.6;
  while (select_form() == QpForm::kCondensed) set(FL_2, angle += 1e-4);
  for (int k = 0; k < 1000; ++k) {
    set(FL_2, angle + (k % 2 ? 1e-3 : -1e-3));
    BOOST_REQUIRE((select_form() == QpForm::kGeneral));
  }
}

BOOST_FIXTURE_TEST_CASE(a_stance_foot_near_hip_height_is_singular_and_a_swing_foot_is_not,
                        WideRangeRobot) {
  double angle = 0.8;
  while (select_form() == QpForm::kCondensed) set(FL_1, angle += 1e-4);
  const double depth = dynamics.legs()[FL_].depth;
  BOOST_TEST(std::abs(depth - 0.05) < 1e-3);
  BOOST_TEST(determinant() > 1.05 * min_determinant);  // the depth decides
  while (select_form() == QpForm::kGeneral) set(FL_1, angle -= 1e-4);
  BOOST_TEST(std::abs(dynamics.legs()[FL_].depth - 0.06) < 1e-3);
  reference.feet[FL_].stance = false;
  set(FL_1, angle + 0.05);
  BOOST_TEST((select_form() == QpForm::kCondensed));
}

BOOST_FIXTURE_TEST_CASE(softness_is_continuous_and_zero_in_the_condensed_form, WideRangeRobot) {
  double last = 0.0, softest = 0.0;
  for (double angle = -1.6; angle < 0.4; angle += 1e-3) {
    set(FL_2, angle);
    const QpForm form = select_form();
    const double soft = selector.softness()[FL_];
    BOOST_REQUIRE((soft == 0.0 || form == QpForm::kGeneral));
    BOOST_REQUIRE(std::abs(soft - last) < 0.05);
    last = soft;
    softest = std::max(softest, soft);
  }
  BOOST_TEST(softest == 1.0);
  BOOST_TEST(selector.softness()[FR_] == 0.0);
}

BOOST_FIXTURE_TEST_CASE(requested_form_is_used_even_near_a_singularity, WideRangeRobot) {
  BOOST_TEST((select_form(QpForm::kGeneral) == QpForm::kGeneral));
  set(FL_2, 0.0);
  BOOST_TEST((select_form(QpForm::kCondensed) == QpForm::kCondensed));
  BOOST_TEST(selector.singular()[FL_]);
}

BOOST_AUTO_TEST_SUITE_END()
