// SPDX-License-Identifier: BSD-3-Clause
#include "gait/step_timing.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace surefoot {

namespace {

// [h] Distance of the capture point from the line at touchdown that a step reaches. Derived: the
// largest foothold offset, 0.83 h, plus the distance that the hips have moved. Pushed stands of go1
// and b1 survive most pushes at 1.0, fewer at 0.7 and at 1.4.
constexpr double kReach = 1.0;
// Smallest factor. Chosen: a swing then takes 0.1 s at h = 0.3 m. With 0.35 to 0.7 as many pushes
// are survived within the scatter of seeds.
constexpr double kMinFactor = 0.5;

// The two feet that stand while the others swing.
struct StanceLine {
  Eigen::Vector2d p_first, p_second;  // [m] contact points, world axes
  Eigen::Vector2d p_nominal_middle;   // [m] between them in the nominal stance, from p_com
  double age;                         // [s] since they were scheduled to land
};

// Return whether exactly two feet are scheduled to stand.
bool find_stance_line(const GaitSize& size, const GaitClock& clock, const GaitTiming& timing,
                      const FeetMatrix& p_world_feet, double yaw, StanceLine& line) noexcept {
  std::array<int, 2> legs{};
  int count = 0;
  for (int leg = 0; leg < kLegs; ++leg) {
    if (clock.in_swing(leg)) continue;
    if (count == 2) return false;
    legs[count++] = leg;
  }
  if (count != 2) return false;
  line.p_first = p_world_feet.col(legs[0]).head<2>();
  line.p_second = p_world_feet.col(legs[1]).head<2>();
  line.p_nominal_middle =
      Eigen::Rotation2Dd(yaw) *
      Eigen::Vector2d(0.5 *
                      (size.nominal_feet.col(legs[0]) + size.nominal_feet.col(legs[1])).head<2>());
  line.age = clock.stance_progress(legs[0]) * timing.stance_time();
  return true;
}

// Return the distance [m], across the line, of the capture point from where the trajectory has it.
// In a steady walk the body is at the nominal place over the line in the middle of the stance.
double capture_error(const GaitSize& size, const StanceLine& line, double stance_time,
                     const HorizontalMotion& measured, const BodyTrajectory& body) noexcept {
  const Eigen::Vector2d p_nominal = 0.5 * (line.p_first + line.p_second) - line.p_nominal_middle +
                                    (line.age - 0.5 * stance_time) * body.v_world();
  const Eigen::Vector2d error =
      measured.p_com - p_nominal + size.time * (measured.v_com - body.v_world());
  const Eigen::Vector2d along = (line.p_second - line.p_first).normalized();
  return std::abs(along.x() * error.y() - along.y() * error.x());
}

}  // namespace

double swing_time_factor(const GaitSize& size, const GaitClock& clock, const GaitTiming& timing,
                         const FeetMatrix& p_world_feet, const HorizontalMotion& measured,
                         const BodyTrajectory& body) noexcept {
  StanceLine line;
  if (!find_stance_line(size, clock, timing, p_world_feet, body.yaw(), line)) return 1.0;
  double time_left = 0.0;
  for (int leg = 0; leg < kLegs; ++leg) {
    if (!clock.in_swing(leg)) continue;
    time_left = std::max(time_left, (1.0 - clock.swing_progress(leg)) * timing.swing_time());
  }
  const double distance = capture_error(size, line, timing.stance_time(), measured, body);
  // Numerical: the smallest numbers only avoid a division by zero.
  const double time = size.time * std::log(kReach * size.height / std::max(distance, 1e-6));
  return std::clamp(time / std::max(time_left, 1e-6), kMinFactor, 1.0);
}

}  // namespace surefoot
