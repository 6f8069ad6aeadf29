// SPDX-License-Identifier: BSD-3-Clause
#include "reference/reach.hpp"

#include <algorithm>
#include <limits>

#include "reference/support_polygon.hpp"

namespace surefoot {

namespace {
constexpr double kRadiansPerMetre = 5.0;  // how bad an edge or a high foot is, beside a joint limit
}

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

ReachVerdict Reach::judge(const Gains& gains, const Vector3& p_base, const Quaternion& R_base,
                          const FeetMatrix& feet, const Vector3& gravity) noexcept {
  if (!kinematics_.solve(p_base, R_base, feet, Vector3::UnitZ())) {
    return {{ReachLimit::kUnreachable, -1}, std::numeric_limits<double>::infinity()};
  }
  ReachVerdict worst;
  const RobotConfig& config = robot_.config();
  for (int i = 0; i < kMotors; ++i) {
    const double q = kinematics_.q()[robot_.motor_to_q()[i]];
    const JointRange range = motion_range(config, i);
    const double room = std::min(q - range.lower, range.upper - q);
    const double missing = gains.reach_joint_margin - room;
    if (missing > worst.violation) worst = {{ReachLimit::kJoint, i}, missing};
  }
  for (int leg = 0; leg < kLegs; ++leg) {
    const double missing = kRadiansPerMetre * (gains.reach_foot_depth - kinematics_.depth()[leg]);
    if (missing > worst.violation) worst = {{ReachLimit::kFootHeight, 3 * leg}, missing};
  }
  const Vector3& com = kinematics_.p_com();
  const Vector3 ground = com - (com.z() / gravity.z()) * gravity;
  const SupportPolygon polygon(feet, {true, true, true, true});
  const double missing =
      kRadiansPerMetre * (gains.reach_support_margin - polygon.margin(ground.head<2>()));
  if (missing > worst.violation) worst = {{ReachLimit::kSupport, -1}, missing};
  return worst;
}

}  // namespace surefoot
