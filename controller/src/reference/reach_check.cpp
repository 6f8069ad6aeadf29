// SPDX-License-Identifier: BSD-3-Clause
#include "reference/reach_check.hpp"

#include <algorithm>
#include <limits>

#include "reference/support_polygon.hpp"

namespace surefoot {

namespace {
// [rad/m] Factor that converts the violation of a limit in metres to radians, so that it can be
// compared with the violation of a joint limit. Derived: the inverse of the length of a thigh or
// shank, 0.20 to 0.21 m on a1, go1 and go2.
constexpr double kViolationPerMetre = 5.0;
}  // namespace

const char* to_string(ReachLimit limit) noexcept {
  switch (limit) {
    case ReachLimit::kNone:
      return "none";
    case ReachLimit::kJoint:
      return "joint";
    case ReachLimit::kSupport:
      return "support";
    case ReachLimit::kFootHeight:
      return "foot_height";
    case ReachLimit::kUnreachable:
      return "unreachable";
    case ReachLimit::kNotFinite:
      return "not_finite";
  }
  return "unknown";
}

ReachResult ReachCheck::evaluate(const Gains& gains, const Vector3& p_base,
                                 const Quaternion& R_base, const FeetMatrix& feet,
                                 const Vector3& gravity) noexcept {
  // The ground normal is the z axis of the support frame.
  if (!kinematics_.solve(p_base, R_base, feet, Vector3::UnitZ())) {
    return {{ReachLimit::kUnreachable, -1}, std::numeric_limits<double>::infinity()};
  }
  ReachResult worst;
  const RobotConfig& config = robot_.config();
  for (int i = 0; i < kMotors; ++i) {
    const double q = kinematics_.q()[robot_.motor_to_q()[i]];
    const JointRange range = motion_range(config, i);
    const double joint_margin = std::min(q - range.lower, range.upper - q);
    const double shortfall = gains.reach_joint_margin - joint_margin;
    if (shortfall > worst.violation) worst = {{ReachLimit::kJoint, i}, shortfall};
  }
  // ReachLimit::kFootHeight: the depth of a foot below its hip axis is too small.
  for (int leg = 0; leg < kLegs; ++leg) {
    const double shortfall =
        kViolationPerMetre * (gains.reach_foot_depth - kinematics_.depth()[leg]);
    if (shortfall > worst.violation) worst = {{ReachLimit::kFootHeight, 3 * leg}, shortfall};
  }
  const Vector3& com = kinematics_.p_com();
  // Centre of mass, projected to the ground along gravity.
  const Vector3 com_on_ground = com - (com.z() / gravity.z()) * gravity;
  const SupportPolygon polygon(feet, {true, true, true, true});
  const double shortfall =
      kViolationPerMetre * (gains.reach_support_margin - polygon.margin(com_on_ground.head<2>()));
  if (shortfall > worst.violation) worst = {{ReachLimit::kSupport, -1}, shortfall};
  return worst;
}

}  // namespace surefoot
