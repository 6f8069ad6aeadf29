// SPDX-License-Identifier: BSD-3-Clause
#include "wbc/own_limits.hpp"

#include <algorithm>

namespace surefoot {

namespace {
constexpr double kMore = 1e4;    // [rad/s^2] that no body asks of a leg
constexpr int kSweeps = 20;      // from which on it changes next to nothing
constexpr double kLever = 1e-9;  // [m^2] of a joint that does not move the foot

// Accelerations of a leg's joints within bounds with which its foot does most nearly what it was
// asked: least squares, one joint after the other (projected Gauss-Seidel).
Vector3 within(const Matrix3& J, const Vector3& asked, const Vector3& lower,
               const Vector3& upper) noexcept {
  Vector3 a = asked.cwiseMax(lower).cwiseMin(upper);
  Vector3 missing = J * (asked - a);
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    for (int j = 0; j < 3; ++j) {
      const Vector3 way = J.col(j);
      const double step = way.dot(missing) / std::max(way.squaredNorm(), kLever);
      const double next = std::clamp(a[j] + step, lower[j], upper[j]);
      missing -= (next - a[j]) * way;
      a[j] = next;
    }
  }
  return a;
}

}  // namespace

void let_go(const JointTable& joints, double fade, const Eigen::Vector4d& contact,
            const Reference& reference, JointLimits& limits) noexcept {
  for (std::size_t k = 0; k < joints.size(); ++k) {
    const int leg = joints[k].group;
    double bears = 1.0;
    if (leg < kLegs) {
      bears = planned_load(reference.feet[leg]) * std::clamp(contact[leg], 0.0, 1.0);
    }
    limits.more[k] = kMore * (1.0 - fade) * (1.0 - bears);
  }
}

void keep_own_limits(const JointTable& joints, const Dynamics& dynamics, const JointLimits& limits,
                     Eigen::VectorXd& accelerations, Eigen::VectorXd& torques) noexcept {
  for (int leg = 0; leg < kLegs; ++leg) {
    const int first = 3 * leg;
    Vector3 asked, lower, upper;
    for (int j = 0; j < 3; ++j) {
      const int k = first + j;
      asked[j] = accelerations[joints[k].v];
      // No more than it was let go by: what a limit that all must keep gave way by is not its own.
      lower[j] = std::min(limits.a_lower[k], asked[j] + limits.more[k]);
      upper[j] = std::max(limits.a_upper[k], asked[j] - limits.more[k]);
      if (limits.more[k] <= 0.0) lower[j] = upper[j] = asked[j];
    }
    if ((asked.array() >= lower.array()).all() && (asked.array() <= upper.array()).all()) continue;
    const Vector3 change = within(dynamics.legs()[leg].J_leg, asked, lower, upper) - asked;
    for (int j = 0; j < 3; ++j) accelerations[joints[first + j].v] += change[j];
    torques.segment<3>(first) += dynamics.legs()[leg].M_leg * change;
  }
}

}  // namespace surefoot
