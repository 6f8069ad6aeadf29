// SPDX-License-Identifier: BSD-3-Clause
#include "gait/walk_order.hpp"

#include "reference/support_polygon.hpp"

namespace surefoot {

namespace {

// All cyclic orders of four feet.
constexpr WalkOrder kOrders[] = {{RR_, FR_, RL_, FL_}, {RR_, FL_, RL_, FR_}, {RR_, RL_, FR_, FL_},
                                 {RR_, FL_, FR_, RL_}, {RR_, FR_, FL_, RL_}, {RR_, RL_, FL_, FR_}};
// Share of the present sway below which another order is better. Chosen: directions half-way
// between two orders do not make the order change to and fro.
constexpr double kClearlyLess = 0.8;

}  // namespace

double sway_of(const WalkOrder& order, const GaitSize& size, const WalkVelocity& velocity,
               double period, double margin) noexcept {
  double sway = 0.0;
  for (int swing = 0; swing < kLegs; ++swing) {
    // Relative to the body, a stance foot moves with the opposite of its hip's velocity, and is
    // under its hip at mid-stance. In the middle of this swing, the foot that lifts off next is a
    // quarter of the period past that.
    FeetMatrix feet = size.nominal_feet;
    for (int later = 1; later < kLegs; ++later) {
      const int leg = order[(swing + later) % kLegs];
      const Vector3 hip = size.nominal_feet.col(leg);
      const Eigen::Vector2d v(velocity.vx - velocity.yaw_rate * hip.y(),
                              velocity.vy + velocity.yaw_rate * hip.x());
      feet.col(leg).head<2>() += (0.25 * later - 0.5) * period * v;
    }
    std::array<bool, kLegs> stance = {true, true, true, true};
    stance[order[swing]] = false;
    sway +=
        SupportPolygon(feet, stance).nearest_inside(Eigen::Vector2d::Zero(), margin).squaredNorm();
  }
  return sway;
}

WalkOrder best_walk_order(const WalkOrder& present, const GaitSize& size,
                          const WalkVelocity& velocity, double period, double margin) noexcept {
  WalkOrder best = present;
  double least = kClearlyLess * sway_of(present, size, velocity, period, margin);
  for (const WalkOrder& order : kOrders) {
    if (order == present) continue;
    const double sway = sway_of(order, size, velocity, period, margin);
    if (sway >= least) continue;
    least = sway;
    best = order;
  }
  return best;
}

}  // namespace surefoot
