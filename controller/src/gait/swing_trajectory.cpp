// SPDX-License-Identifier: BSD-3-Clause
#include "gait/swing_trajectory.hpp"

#include <algorithm>

namespace surefoot {

namespace {

// [s] Shortest time in which a moved foothold is still reached. Chosen: ten control periods; in
// less the acceleration of the foot would exceed what the legs can do.
constexpr double kMinTimeLeft = 0.02;

}  // namespace

void SwingTrajectory::lift_off(const Vector3& p_world) noexcept {
  p_ = p_world;
  v_.setZero();
  a_.setZero();
  z_start_ = p_world.z();
}

void SwingTrajectory::update(const Shape& shape, const Vector3& foothold, double progress,
                             double swing_time, double time_left, double dt) noexcept {
  for (int axis = 0; axis < 2; ++axis) move_horizontally(axis, foothold[axis], time_left, dt);
  // Height 64 s^3 (1 - s)^3 of the arc, plus the quintic from rest at lift-off to the foothold,
  // where the foot moves down with the touchdown speed.
  const double s = progress, r = 1.0 - s;
  const double bump = 64.0 * s * s * s * r * r * r;
  const double bump_1 = 192.0 * s * s * r * r * (r - s);
  const double bump_2 = 384.0 * s * r * (r * r - 3.0 * s * r + s * s);
  const double d = foothold.z() - z_start_;
  const double slope = -shape.landing_speed * swing_time;  // dz/ds at the end
  const double c3 = 10.0 * d - 4.0 * slope, c4 = -15.0 * d + 7.0 * slope,
               c5 = 6.0 * d - 3.0 * slope;
  const double line = s * s * s * (c3 + s * (c4 + s * c5));
  const double line_1 = s * s * (3.0 * c3 + s * (4.0 * c4 + s * 5.0 * c5));
  const double line_2 = s * (6.0 * c3 + s * (12.0 * c4 + s * 20.0 * c5));
  p_.z() = z_start_ + line + shape.height * bump;
  v_.z() = (line_1 + shape.height * bump_1) / swing_time;
  a_.z() = (line_2 + shape.height * bump_2) / (swing_time * swing_time);
}

void SwingTrajectory::reach_down(double speed, double lowest, double dt) noexcept {
  v_ = p_.z() > lowest ? Vector3(-speed * Vector3::UnitZ()) : Vector3::Zero();
  a_.setZero();
  p_ += dt * v_;
}

void SwingTrajectory::move_horizontally(int axis, double target, double time_left,
                                        double dt) noexcept {
  double &p = p_[axis], &v = v_[axis], &a = a_[axis];
  const double T = std::max(time_left, kMinTimeLeft);
  const double d = target - p, vT = v * T, aTT = a * T * T;
  const double j3 = (20.0 * d - 12.0 * vT - 3.0 * aTT) / (2.0 * T * T * T);
  const double j4 = (-30.0 * d + 16.0 * vT + 3.0 * aTT) / (2.0 * T * T * T * T);
  const double j5 = (12.0 * d - 6.0 * vT - aTT) / (2.0 * T * T * T * T * T);
  p += dt * (v + dt * (0.5 * a + dt * (j3 + dt * (j4 + dt * j5))));
  v += dt * (a + dt * (3.0 * j3 + dt * (4.0 * j4 + dt * 5.0 * j5)));
  a += dt * (6.0 * j3 + dt * (12.0 * j4 + dt * 20.0 * j5));
}

}  // namespace surefoot
