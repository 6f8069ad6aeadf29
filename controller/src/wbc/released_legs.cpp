// SPDX-License-Identifier: BSD-3-Clause
#include "wbc/released_legs.hpp"

#include <algorithm>

#include "tasks/foot_loads.hpp"

namespace surefoot {

namespace {
// [rad/s^2] Largest widening of the joint acceleration limits. Chosen larger than any acceleration
// that the QP requires of a leg; runaway legs reached 400.
constexpr double kReleasedRange = 1e4;
constexpr int kSweeps = 20;  // chosen: with three joints, further sweeps hardly change the result
constexpr double kMinSquaredLever =
    1e-9;  // [m^2] numerical: avoids a division by zero if a joint does not move the foot

// Bounds on the accelerations of a leg's joints [rad/s^2].
struct Bounds {
  Vector3 lower, upper;
  bool contain(const Vector3& a) const noexcept {
    return (a.array() >= lower.array()).all() && (a.array() <= upper.array()).all();
  }
};

bool is_released(const JointLimits& limits, int leg) noexcept {
  return limits.a_widening.segment<3>(3 * leg).maxCoeff() > 0.0;
}

// Return the bounds to which the joint accelerations of a leg are clamped: the joint limits. If the
// QP has used a slack to violate even the limits widened by a_widening, the excess over the widened
// limit is kept: that bound moves outward by the excess. So clamping changes no acceleration by
// more than a_widening.
Bounds released_bounds(const JointLimits& limits, int leg, const Vector3& desired) noexcept {
  Bounds bounds;
  for (int j = 0; j < 3; ++j) {
    const int k = 3 * leg + j;
    bounds.lower[j] = std::min(limits.a_lower[k], desired[j] + limits.a_widening[k]);
    bounds.upper[j] = std::max(limits.a_upper[k], desired[j] - limits.a_widening[k]);
  }
  return bounds;
}

// Return the joint accelerations within `bounds` that bring the foot acceleration closest to that
// of `desired`. Method: least squares by projected Gauss-Seidel, one joint after the other.
Vector3 nearest_within(const Matrix3& J, const Vector3& desired, const Bounds& bounds) noexcept {
  Vector3 a = desired.cwiseMax(bounds.lower).cwiseMin(bounds.upper);
  Vector3 residual = J * (desired - a);
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    for (int j = 0; j < 3; ++j) {
      const Vector3 column = J.col(j);
      const double step = column.dot(residual) / std::max(column.squaredNorm(), kMinSquaredLever);
      const double next = std::clamp(a[j] + step, bounds.lower[j], bounds.upper[j]);
      residual -= (next - a[j]) * column;
      a[j] = next;
    }
  }
  return a;
}

// Return the change [rad/s^2] that brings the joint accelerations `desired` of a leg within
// released_bounds(). J: Jacobian of the leg.
Vector3 clamping_change(const JointLimits& limits, int leg, const Matrix3& J,
                        const Vector3& desired) noexcept {
  const Bounds bounds = released_bounds(limits, leg, desired);
  if (bounds.contain(desired)) return Vector3::Zero();
  return nearest_within(J, desired, bounds) - desired;
}

}  // namespace

void release_unloaded_legs(const JointTable& joints, double fade, const Eigen::Vector4d& contact,
                           const Reference& reference, JointLimits& limits) noexcept {
  // A robot that steps does not brake at an edge: its unloaded legs are always released.
  const double share = reference.stepping ? 1.0 : 1.0 - fade;
  for (std::size_t k = 0; k < joints.size(); ++k) {
    const int leg = joints[k].group;
    double load = 1.0;
    if (leg < kLegs) {
      load = planned_load(reference.feet[leg]) * std::clamp(contact[leg], 0.0, 1.0);
    }
    limits.a_widening[k] = kReleasedRange * share * (1.0 - load);
  }
}

void limit_foot_accelerations(const Dynamics& dynamics, const JointLimits& limits,
                              double smallest_determinant, FeetMatrix& feet_acceleration) noexcept {
  for (int leg = 0; leg < kLegs; ++leg) {
    if (!is_released(limits, leg)) continue;
    const LegDynamics& L = dynamics.legs()[leg];
    Matrix3 inverse;
    bool invertible = false;
    L.J_leg.computeInverseWithCheck(inverse, invertible, smallest_determinant);
    if (!invertible) continue;
    const Vector3 desired = inverse * (feet_acceleration.col(leg) - L.drift);
    feet_acceleration.col(leg) += L.J_leg * clamping_change(limits, leg, L.J_leg, desired);
  }
}

void clamp_released_legs(const JointTable& joints, const Dynamics& dynamics,
                         const JointLimits& limits, Eigen::VectorXd& accelerations,
                         Eigen::VectorXd& torques) noexcept {
  for (int leg = 0; leg < kLegs; ++leg) {
    if (!is_released(limits, leg)) continue;
    const LegDynamics& L = dynamics.legs()[leg];
    const int first = 3 * leg;
    Vector3 desired;
    for (int j = 0; j < 3; ++j) desired[j] = accelerations[joints[first + j].v];
    const Vector3 change = clamping_change(limits, leg, L.J_leg, desired);
    for (int j = 0; j < 3; ++j) accelerations[joints[first + j].v] += change[j];
    torques.segment<3>(first) += L.M_leg * change;
  }
}

}  // namespace surefoot
