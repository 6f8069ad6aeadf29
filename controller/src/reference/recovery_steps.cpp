// SPDX-License-Identifier: BSD-3-Clause
#include "reference/recovery_steps.hpp"

#include <algorithm>
#include <cmath>

#include "reference/capture_margin.hpp"
#include "reference/foot_to_lift.hpp"

namespace surefoot {

namespace {

// Unit h: height of the centre of mass above the feet. All values are chosen, except where a
// measurement is given; tests/closed_loop/test_recovery_steps.py covers them together.

// A foot that has lost contact steps if the capture margin is below this share of the gain
// edge_margin. If larger: feet step at weak pushes (test_no_foot_steps_at_a_75_percent_push). If
// smaller: the foot steps too late.
constexpr double kStepMarginShare = 0.65;
// [h] The body counts as moving when the capture point is farther than this from the centre of
// mass. Chosen larger than the sway of a standing robot, and smaller than the distance in pushes
// that need a step.
constexpr double kMovingDistance = 0.1;
// Contact confidences. Below kOffGroundConfidence a foot has lifted off. Above kContactConfidence a
// foot is loaded or has landed. Between these values its phase does not change (hysteresis).
constexpr double kOffGroundConfidence = 0.3;
constexpr double kContactConfidence = 0.5;
// [sqrt(h / g)] Time from the start of a step until the foot is pressed down, unloading included:
// 0.1 s at h = 0.3 m. If shorter: the leg would have to move too fast. If longer: the capture point
// moves too far away; in this time its distance from the support grows by a factor of
// exp(0.6) = 1.8.
constexpr double kSwingTime = 0.6;
// [h] Height of a swing foot: 24 mm at h = 0.3 m. Larger than the displacement of the contact point
// by rolling of the foot.
constexpr double kLiftHeight = 0.08;
// [h] Depth of the foot's desired position below the ground at landing. A position below the ground
// ensures contact.
constexpr double kPressDepth = 0.1;
// [h] Capture margin after landing that a step must exceed. Chosen just above 0; with a margin
// below 0 the robot tips over.
constexpr double kMinMargin = 0.01;
// [sqrt(g h)] Largest speed of a foot's desired position. Measured: at a latency of 20 ms a go2
// survives 100 % of the pushes with this value, and 97.5 % with half of this value (git b8a299d).
constexpr double kFootSpeed = 2.0;
// [s] Time constant with which the nominal position moves to a foot that has landed.
// (kNominalFeetDriftTime in support_frame.cpp is for feet that have not stepped.) If shorter: the
// references jump. Shorter than kSwingTime (0.1 s at h = 0.3 m), so that the nominal position has
// moved before the next foot lands.
constexpr double kNominalFootFollowTime = 0.05;
constexpr double kOffsetDecayTime =
    0.2;  // [s] time constant with which foot offsets decay in stop()

// Return the height of the centre of mass above the feet. At least 0.05 m, as in capture_point().
double height_over(const FeetMatrix& p_world_feet, const Dynamics& dynamics) noexcept {
  return std::max(dynamics.p_world_com().z() - p_world_feet.row(2).mean(), 0.05);
}

// Return the component of a vector in the plane of the feet.
Vector3 project_to_plane(const Vector3& vector, const Vector3& normal) noexcept {
  return vector - normal.dot(vector) * normal;
}

}  // namespace

void RecoverySteps::update(const Gains& gains, const Dynamics& dynamics,
                           const FeetMatrix& p_world_feet, const Eigen::Vector4d& contact,
                           SupportFrame& support, double dt) noexcept {
  if (gains.foot_step <= 0.0) return stop(dt);
  const FeetMatrix nominal_feet = support.p_world_nominal_feet();
  const FeetMatrix from_nominal = p_world_feet - nominal_feet;
  const double height = height_over(p_world_feet, dynamics);
  const Eigen::Vector2d capture = capture_point(dynamics);
  body_moving_ = (capture - dynamics.p_world_com().head<2>()).norm() > kMovingDistance * height;
  update_stride(gains, support, nominal_feet, capture);
  select_foot_to_lift(p_world_feet, nominal_feet, contact, capture, kMinMargin * height);
  const double normalised_dt = dt / std::sqrt(height / kGravity);
  for (int leg = 0; leg < kLegs; ++leg) {
    phase_time_[leg] += normalised_dt;
    update_phase(leg, contact[leg], project_to_plane(from_nominal.col(leg), support.normal()));
    if (phase_[leg] != FootPhase::kStance) {
      update_swing(leg, from_nominal.col(leg), support.normal(), height, dt);
    } else {
      const Vector3 nominal_change = dt / (dt + kNominalFootFollowTime) * foot_offsets_.col(leg);
      support.move_nominal_foot(leg, nominal_change);
      foot_offsets_.col(leg) -= nominal_change;
    }
  }
}

void RecoverySteps::stop(double dt) noexcept {
  phase_.fill(FootPhase::kStance);
  foot_offsets_ *= 1.0 - dt / (dt + kOffsetDecayTime);
}

void RecoverySteps::exclude_swing_feet(const SupportFrame& support, FeetMatrix& p_world_feet,
                                       Eigen::Vector4d& contact) const noexcept {
  const FeetMatrix nominal_feet = support.p_world_nominal_feet();
  p_world_feet -= foot_offsets_;
  for (int leg = 0; leg < kLegs; ++leg) {
    if (phase_[leg] == FootPhase::kStance) continue;
    p_world_feet.col(leg) = nominal_feet.col(leg);
    contact[leg] = 0.0;
  }
}

// Compute the edge proximity and the stride. The edge proximity is 1 with the capture point at an
// edge of the polygon of the nominal foot positions. The stride is the edge proximity times the
// vector from the support origin to the capture point, limited to foot_step.
void RecoverySteps::update_stride(const Gains& gains, const SupportFrame& support,
                                  const FeetMatrix& p_world_nominal_feet,
                                  const Eigen::Vector2d& capture) noexcept {
  const SupportPolygon polygon(p_world_nominal_feet, {true, true, true, true});
  edge_proximity_ = 1.0 - std::clamp(polygon.margin(capture) / gains.edge_margin, 0.0, 1.0);
  Vector3 capture_offset = Vector3::Zero();
  capture_offset.head<2>() = capture - support.origin().head<2>();
  stride_ = edge_proximity_ * project_to_plane(capture_offset, support.normal());
  stride_ *= std::min(1.0, gains.foot_step / std::max(stride_.norm(), 1e-6));
}

// If the capture point is outside, select a loaded foot whose step would bring the capture point
// back inside, and begin to unload it. Only one foot is unloaded at a time.
void RecoverySteps::select_foot_to_lift(const FeetMatrix& p_world_feet,
                                        const FeetMatrix& p_world_nominal_feet,
                                        const Eigen::Vector4d& contact,
                                        const Eigen::Vector2d& capture,
                                        double min_margin) noexcept {
  if (edge_proximity_ < 1.0) {
    lift_failed_.fill(false);
    return;
  }
  std::array<bool, kLegs> loaded;
  for (int leg = 0; leg < kLegs; ++leg) {
    if (phase_[leg] == FootPhase::kLiftingOff) return;
    loaded[leg] = phase_[leg] == FootPhase::kStance && contact[leg] > kContactConfidence;
  }
  const FeetMatrix goals = p_world_nominal_feet.colwise() + stride_;
  const int leg = foot_to_lift(p_world_feet, goals, loaded, capture, kSwingTime, min_margin);
  if (leg < 0 || lift_failed_[leg]) return;
  phase_[leg] = FootPhase::kLiftingOff;
  phase_time_[leg] = 0.0;
}

// Update the phase of a foot. A foot swings when it has lost contact, while the body moves near a
// support edge or while the foot is being unloaded. It returns to stance when it lands, or when
// unloading has not lifted it off within kSwingTime. From then on its desired position is the place
// where it stands.
void RecoverySteps::update_phase(int leg, double contact, const Vector3& from_nominal) noexcept {
  FootPhase& phase = phase_[leg];
  if (phase == FootPhase::kStance && body_moving_ && contact < kOffGroundConfidence &&
      edge_proximity_ > 1.0 - kStepMarginShare) {
    phase = FootPhase::kSwinging;
    phase_time_[leg] = 0.0;
  } else if (phase == FootPhase::kLiftingOff && contact < kOffGroundConfidence) {
    phase = FootPhase::kSwinging;
  } else if ((phase == FootPhase::kSwinging && contact > kContactConfidence) ||
             (phase == FootPhase::kLiftingOff && phase_time_[leg] > kSwingTime)) {
    lift_failed_[leg] = phase == FootPhase::kLiftingOff;
    phase = FootPhase::kStance;
    foot_offsets_.col(leg) = from_nominal;
  }
}

// Move the desired position of a stepping foot. Before kSwingTime, move it towards the end of the
// stride, no faster than kFootSpeed and no higher than kLiftHeight. After kSwingTime, move it
// straight down to kPressDepth below the ground.
void RecoverySteps::update_swing(int leg, const Vector3& from_nominal, const Vector3& normal,
                                 double height, double dt) noexcept {
  Vector3 in_plane_offset = project_to_plane(foot_offsets_.col(leg), normal);
  double normal_offset = -kPressDepth * height;
  if (phase_time_[leg] < kSwingTime) {
    const Vector3 remaining = stride_ - in_plane_offset;
    const double max_step = kFootSpeed * std::sqrt(kGravity * height) * dt;
    in_plane_offset += remaining * std::min(1.0, max_step / std::max(remaining.norm(), max_step));
    // A swing foot descends as it approaches its landing position. For a foot that is still in
    // contact the desired position is kLiftHeight above the ground, so that the foot lifts off.
    const double lift = kLiftHeight * height;
    normal_offset = is_lifting_off(leg)
                        ? lift
                        : std::min(lift, project_to_plane(stride_ - from_nominal, normal).norm() +
                                             normal_offset);
  }
  foot_offsets_.col(leg) = in_plane_offset + normal_offset * normal;
}

}  // namespace surefoot
