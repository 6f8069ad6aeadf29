// SPDX-License-Identifier: BSD-3-Clause
#include "gait/step_timing.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace surefoot {

namespace {

double env(const char* n, double d) { const char* s = std::getenv(n); return s ? std::atof(s) : d; }
// [h] Reach of a step.
const double kReach = env("SF_REACH", 1.0);
// Smallest factor.
const double kMinFactor = env("SF_MINF", 0.5);

}  // namespace

double swing_time_factor(const GaitSize& size, const GaitClock& clock, const FeetMatrix& p_world_feet,
                         const HorizontalMotion& measured, const BodyTrajectory& body) noexcept {
  const Eigen::Rotation2Dd R(body.yaw());
  Eigen::Matrix<double, 2, 2> feet;
  Eigen::Vector2d nominal = Eigen::Vector2d::Zero();
  double time_left = 0.0, stood = 0.0;
  int stance_feet = 0;
  for (int leg = 0; leg < kLegs; ++leg) {
    time_left = std::max(time_left, clock.time_to_touchdown(leg));
    if (clock.in_swing(leg)) continue;
    if (stance_feet == 2) return 1.0;
    feet.col(stance_feet++) = p_world_feet.col(leg).head<2>();
    nominal += 0.5 * (R * Eigen::Vector2d(size.nominal_feet.col(leg).head<2>()));
    stood = clock.timing().stance_time() - clock.time_to_liftoff(leg);
  }
  if (stance_feet != 2) return 1.0;
  const Eigen::Vector2d from_line =
      measured.p_com + nominal - feet.rowwise().mean() -
      (stood - 0.5 * clock.timing().stance_time()) * body.v_world() * 1.0;
  const Eigen::Vector2d error = from_line + size.time * (measured.v_com - body.v_world());
  const Eigen::Vector2d line = (feet.col(1) - feet.col(0)).normalized();
  const double distance = std::abs(line.x() * error.y() - line.y() * error.x());
  const double time = size.time * std::log(kReach * size.height / std::max(distance, 1e-6));
  return std::clamp(time / std::max(time_left, 1e-6), kMinFactor, 1.0);
}

}  // namespace surefoot
