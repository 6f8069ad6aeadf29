// SPDX-License-Identifier: BSD-3-Clause
#include <boost/test/unit_test.hpp>
#include <functional>

#include "gait/swing_trajectory.hpp"

using namespace surefoot;

namespace {

constexpr double kSwingTime = 0.2;
const SwingTrajectory::Shape kShape{0.08, 0.15};  // [m], [m/s]
const Vector3 kStart(0.1, -0.2, 0.03);

struct SwingFixture {
  SwingTrajectory swing;
  SwingFixture() { swing.lift_off(kStart); }

  // Swing to foothold(progress); call `seen` after each tick.
  void run(const std::function<Vector3(double)>& foothold, double dt,
           const std::function<void(double)>& seen = nullptr) {
    const int ticks = static_cast<int>(std::lround(kSwingTime / dt));
    for (int k = 1; k <= ticks; ++k) {
      const double progress = static_cast<double>(k) / ticks;
      swing.update(kShape, foothold(progress), progress, kSwingTime, kSwingTime * (1.0 - progress),
                   dt);
      if (seen) seen(progress);
    }
  }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(gait_swing)

BOOST_FIXTURE_TEST_CASE(swing_starts_at_rest_where_the_foot_lifted_off, SwingFixture) {
  BOOST_TEST((swing.p_world() - kStart).norm() == 0.0);
  BOOST_TEST((swing.v_world().isZero(0.0) && swing.a_world().isZero(0.0)));
  swing.update(kShape, Vector3(0.4, 0.1, 0.0), 0.0, kSwingTime, kSwingTime, 1e-5);
  BOOST_TEST((swing.p_world() - kStart).norm() < 1e-9);
  BOOST_TEST(swing.v_world().norm() < 1e-4);
}

BOOST_FIXTURE_TEST_CASE(foot_reaches_a_foothold_that_moves_during_the_swing, SwingFixture) {
  const Vector3 end(0.35, -0.1, 0.05);
  run(
      [&](double progress) {
        return Vector3(end - std::max(0.8 - progress, 0.0) * Vector3(0.1, -0.1, 0.0));
      },
      0.002);
  BOOST_TEST((swing.p_world() - end).norm() < 2e-3);
  BOOST_TEST(swing.v_world().head<2>().norm() < 0.1);
  BOOST_TEST(std::abs(swing.p_world().z() - end.z()) < 1e-9);
  BOOST_TEST(std::abs(swing.v_world().z() + kShape.landing_speed) < 1e-9);
}

BOOST_FIXTURE_TEST_CASE(foot_stops_horizontally_over_a_fixed_foothold, SwingFixture) {
  const Vector3 end(0.4, -0.2, 0.0);
  double before_landing = 1.0;
  run([&](double) { return end; }, 0.002,
      [&](double progress) {
        if (progress < 0.9) before_landing = (swing.p_world() - end).head<2>().norm();
      });
  BOOST_TEST(before_landing < 4e-3);  // minimum jerk: 0.9 of the time, 99 % of the path
  BOOST_TEST((swing.p_world() - end).head<2>().norm() < 1e-3);
  BOOST_TEST(swing.v_world().head<2>().norm() < 0.05);
}

BOOST_FIXTURE_TEST_CASE(foot_rises_by_the_swing_height_above_the_line_to_its_foothold,
                        SwingFixture) {
  for (const double rise : {0.0, 0.1, -0.1}) {
    swing.lift_off(kStart);
    double highest = -1.0;
    double middle = 0.0;
    run([&](double) { return Vector3(kStart + Vector3(0.2, 0.0, rise)); }, 0.002,
        [&](double progress) {
          highest = std::max(highest, swing.p_world().z() - kStart.z());
          if (std::abs(progress - 0.5) < 1e-9) middle = swing.p_world().z() - kStart.z();
        });
    // The landing speed adds up to 5/32 of speed * time in the middle.
    const double landing = 5.0 / 32.0 * kShape.landing_speed * kSwingTime;
    BOOST_TEST(std::abs(middle - (0.5 * rise + kShape.height + landing)) < 1e-9);
    BOOST_TEST(highest > std::max(rise, 0.0) + 0.04);
  }
}

BOOST_FIXTURE_TEST_CASE(velocity_and_acceleration_are_derivatives_of_the_position, SwingFixture) {
  constexpr double kDt = 1e-4;
  const Vector3 end(0.4, -0.3, 0.06);
  std::vector<Vector3> p, v, a;
  run([&](double) { return end; }, kDt,
      [&](double) {
        p.push_back(swing.p_world());
        v.push_back(swing.v_world());
        a.push_back(swing.a_world());
      });
  // The last 20 ms: a moved foothold is then followed with a fixed horizon.
  for (std::size_t k = 1; k < p.size() - 220; ++k) {
    BOOST_REQUIRE(((p[k + 1] - p[k - 1]) / (2.0 * kDt) - v[k]).norm() < 1e-3);
    BOOST_REQUIRE(((v[k + 1] - v[k - 1]) / (2.0 * kDt) - a[k]).norm() < 0.1);
  }
  BOOST_TEST(a[p.size() / 4].norm() > 1.0);
}

BOOST_FIXTURE_TEST_CASE(late_foot_continues_downwards_at_constant_speed, SwingFixture) {
  run([](double) { return Vector3(0.4, 0.0, 0.0); }, 0.002);
  const Vector3 landing = swing.p_world();
  for (int k = 0; k < 10; ++k) swing.reach_down(0.4, -1.0, 0.002);
  BOOST_TEST((swing.p_world() - landing + 0.008 * Vector3::UnitZ()).norm() < 1e-12);
  BOOST_TEST((swing.v_world() + 0.4 * Vector3::UnitZ()).norm() == 0.0);
  BOOST_TEST(swing.a_world().norm() == 0.0);
}

BOOST_AUTO_TEST_SUITE_END()
