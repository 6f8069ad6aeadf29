// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "common/text.hpp"
#include "robot/robot_checks.hpp"

namespace surefoot {

namespace {

// [m] Bounds of thigh and calf. Chosen: an a1 has 0.2 m, a b2 0.35 m. Outside, a joint lies on the
// next one, or the file has mm.
constexpr double kMinLink = 0.02, kMaxLink = 2.0;
constexpr double kMinOffset = 0.01;  // [m] of a foot from the middle of the feet, chosen
// Least cosine between a joint axis and its expected direction, chosen: 26 deg for tilted hips.
constexpr double kMinAxisCosine = 0.9;
constexpr double kEvenFeet = 0.01;    // [m] usual greatest difference of foot heights, chosen
constexpr double kEqualLegs = 0.001;  // [m] usual greatest difference of left and right, chosen

const char* const kSides[] = {"front right", "front left", "rear right", "rear left"};
const char* const kAxisNames[] = {"x (forward)", "y (left)", "y (left)"};

std::string metres(const Vector3& p) {
  const auto rounded = [](double x) { return to_text(std::round(1000.0 * x) / 1000.0); };
  return "(" + rounded(p.x()) + ", " + rounded(p.y()) + ", " + rounded(p.z()) + ")";
}

void check_axes(const RobotConfig& config, int leg, const LegPlaces& L) {
  for (int k = 0; k < kLegJoints; ++k) {
    const std::string what = "joint '" + config.joint_names[kLegJoints * leg + k] + "'";
    if (!(L.axes[k].norm() > 0.5)) {
      fail_check(config, what, "a joint that does not turn", "a revolute joint");
    }
    const int expected = k == 0 ? 0 : 1;
    if (!(L.axes[k][expected] >= kMinAxisCosine)) {
      fail_check(config, what + ", axis", metres(L.axes[k]) + " in base axes",
                 std::string(kAxisNames[k]) +
                     " as Unitree's motors turn; correct the <axis> or the <origin rpy>");
    }
  }
}

void check_lengths(const RobotConfig& config, int leg, const LegPlaces& L) {
  const std::string& calf = config.joint_names[kLegJoints * leg + 2];
  if (!(L.thigh >= kMinLink && L.thigh <= kMaxLink)) {
    fail_check(
        config, "joint '" + calf + "'",
        to_text(L.thigh) + " m from joint '" + config.joint_names[kLegJoints * leg + 1] + "'",
        to_text(kMinLink) + " .. " + to_text(kMaxLink) + " m, the length of a thigh");
  }
  const double least = std::max(kMinLink, config.foot_radius);
  if (!(L.calf >= least && L.calf <= kMaxLink)) {
    fail_check(config, "foot frame '" + config.foot_frames[leg] + "'",
               to_text(L.calf) + " m from the axis of joint '" + calf + "'",
               to_text(least) + " .. " + to_text(kMaxLink) +
                   " m, the length of a calf and more than the foot radius");
  }
}

void check_place(const RobotConfig& config, int leg, const LegPlaces& L, const Vector3& middle) {
  const Vector3 offset = L.foot - middle;
  const double front = leg < 2 ? 1.0 : -1.0, left = leg % 2 ? 1.0 : -1.0;
  const std::string what = "foot frame '" + config.foot_frames[leg] + "'";
  if (!(front * offset.x() >= kMinOffset && left * offset.y() >= kMinOffset)) {
    fail_check(config, what, metres(offset) + " m from the middle of the feet (forward, left, up)",
               std::string(kSides[leg]) +
                   "; list joints and feet in the order FR FL RR RL, with x forward and y left");
  }
  if (!(L.foot.z() <= L.joints[0].z() - kMinLink)) {
    fail_check(config, what,
               to_text(L.foot.z() - L.joints[0].z()) + " m above joint '" +
                   config.joint_names[kLegJoints * leg] + "' in the standing pose",
               "a foot below its hip; correct the standing pose or the base axes (z up)");
  }
}

}  // namespace

void check_legs(const RobotConfig& config, const std::array<LegPlaces, kLegs>& legs,
                Doubts& doubts) {
  Vector3 middle = Vector3::Zero();
  for (const LegPlaces& L : legs) middle += L.foot / kLegs;
  double low = legs[0].foot.z(), high = low;
  for (int leg = 0; leg < kLegs; ++leg) {
    check_axes(config, leg, legs[leg]);
    check_lengths(config, leg, legs[leg]);
    check_place(config, leg, legs[leg], middle);
    low = std::min(low, legs[leg].foot.z());
    high = std::max(high, legs[leg].foot.z());
  }
  if (high - low > kEvenFeet) {
    doubts.push_back("standing pose: the heights of the feet differ by " + to_text(high - low) +
                     " m with the body level");
  }
  for (int right = 0; right < kLegs; right += 2) {
    const double thigh = legs[right].thigh - legs[right + 1].thigh;
    const double calf = legs[right].calf - legs[right + 1].calf;
    if (std::max(std::abs(thigh), std::abs(calf)) > kEqualLegs) {
      doubts.push_back("legs of '" + config.foot_frames[right] + "' and '" +
                       config.foot_frames[right + 1] + "': thigh and calf differ by " +
                       to_text(thigh) + " and " + to_text(calf) + " m");
    }
  }
}

}  // namespace surefoot
