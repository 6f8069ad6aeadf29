// SPDX-License-Identifier: BSD-3-Clause
#include "wbc/qp_terms_writer.hpp"

#include <algorithm>
#include <cmath>

#include "surefoot/stage_clock.hpp"
#include "tasks/base_orientation_task.hpp"
#include "tasks/base_position_task.hpp"
#include "tasks/body_acceleration.hpp"
#include "tasks/com_task.hpp"
#include "tasks/even_forces.hpp"
#include "tasks/foot_loads.hpp"
#include "tasks/foot_task.hpp"
#include "tasks/momentum_task.hpp"
#include "tasks/posture_task.hpp"
#include "wbc/edge_braking_axes.hpp"
#include "wbc/hold_down.hpp"
#include "wbc/qp_layout.hpp"
#include "wbc/released_legs.hpp"
#include "wbc/support_edge.hpp"

namespace surefoot {

namespace {

// Weight factor of a foot task whose softness is just above 0. The factor falls geometrically to 1
// at softness 1. Chosen. If smaller: the torques jump when the equality becomes a task. If larger:
// the condition number of H grows. Test: torques_stay_bounded_and_continuous_through_a_singularity.
constexpr double kMaxSoftFactor = 10.0;

// Return the external force and moment as a wrench about the base's origin, base axes [N], [N.m].
Vector6 external_wrench_on_base(const Dynamics& dynamics, const RobotState& state) noexcept {
  const Matrix3 R = dynamics.R_world_base().transpose();
  const Vector3 arm = dynamics.p_world_com() - dynamics.p_world_base();
  Vector6 wrench;
  wrench << R * state.f_external, R * (arm.cross(state.f_external) + state.moment_external);
  return wrench;
}

bool is_valid(const TaskRows& rows, Eigen::Index count, int nv) noexcept {
  return rows.A_a.rows() == count && rows.A_a.cols() == nv && rows.A_f.rows() == count &&
         rows.A_f.cols() == QpLayout::kForces && rows.b.size() == count &&
         rows.weight.size() == count && rows.A_a.allFinite() && rows.A_f.allFinite() &&
         rows.b.allFinite() && rows.weight.allFinite() && (rows.weight.array() >= 0.0).all();
}

}  // namespace

QpTermsWriter::QpTermsWriter(const Robot& robot)
    : robot_(robot),
      units_(robot),
      joints_(make_joint_table(robot)),
      terms_(static_cast<int>(joints_.size())) {}

void QpTermsWriter::add_task(std::shared_ptr<Task> task, int rows) {
  terms_.custom.push_back(
      {std::move(task), TaskRows(rows, robot_.nv()), Eigen::VectorXd::Zero(rows)});
}

Status QpTermsWriter::write(const Gains& gains, const Dynamics& dynamics, const RobotState& state,
                            const Reference& reference, const Eigen::Vector4d& foot_softness,
                            const FeetMatrix* previous) noexcept {
  const StageScope stage(Stage::kTasks);
  const double weight = robot_.mass() * kGravity;
  terms_.feet_acceleration = feet_accelerations(gains, reference, dynamics);
  terms_.external_wrench = external_wrench_on_base(dynamics, state);
  terms_.foot_softness = foot_softness;
  for (int leg = 0; leg < kLegs; ++leg) {
    terms_.weight_foot_soft[leg] =
        gains.weight_foot_soft * std::pow(kMaxSoftFactor, 1.0 - foot_softness[leg]);
  }
  terms_.ground_normal = reference.ground_normal;
  terms_.friction = robot_.config().friction * state.friction;
  terms_.normal_max = normal_force_limits(gains, weight, state.contact, reference);
  const double fade = edge_fade(gains, dynamics, reference);
  terms_.hold_down = hold_down_forces(gains, weight, fade, state.contact, reference);
  joint_limits(robot_.config(), joints_, gains, reference.stepping, torque_share_, state,
               terms_.limits);
  release_unloaded_legs(joints_, fade, state.contact, reference, terms_.limits);
  limit_foot_accelerations(dynamics, terms_.limits, units_.smallest_determinant,
                           terms_.feet_acceleration);
  terms_.has_condensed =
      dynamics.condensable() && condense(dynamics, terms_.feet_acceleration, terms_.external_wrench,
                                         units_.smallest_determinant, terms_.condensed);
  write_body(gains, dynamics, state, reference, fade);
  write_forces(gains, reference, previous);
  write_posture(gains, state, reference);
  return write_custom(dynamics, state);
}

void QpTermsWriter::write_body(const Gains& gains, const Dynamics& dynamics,
                               const RobotState& state, const Reference& reference,
                               double fade) noexcept {
  const bool base = reference.body_point == BodyPoint::kBase;
  BodyAcceleration desired = body_acceleration(gains, robot_.mass(), dynamics, state, reference);
  bound_at_edge(gains, fade, units_.length, dynamics.v_world_com().z(), desired);
  auto& [position, orientation, momentum] = terms_.body;
  position = base ? base_position_task(gains, desired.a, dynamics)
                  : com_task(gains, desired.a, state.f_external, robot_.mass());
  const auto edge_factor = [fade](double at_edge) { return fade + (1.0 - fade) * at_edge; };
  position.weight[2] *= edge_factor(gains.edge_height);
  edge_braking_axes(dynamics, state, reference, robot_.mass()).apply_to(position);
  position.scale = base ? units_.scale_base : units_.scale_com;
  orientation = base_orientation_task(gains, desired.alpha, dynamics, reference.stepping);
  orientation.scale = units_.scale_angular;
  orientation.weight.head<2>() *= edge_factor(gains.edge_tilt);
  terms_.body_tasks = 2;
  if (gains.weight_momentum > 0.0) {
    momentum = momentum_task(gains, reference, dynamics);
    momentum.b -= state.moment_external;
    momentum.scale = units_.scale_momentum;
    terms_.body_tasks = 3;
  }
  write_even_forces(dynamics, desired, state, load_shares(gains, state.contact, reference));
}

// Compute the even forces that meet the rows of the position and the orientation task. If the
// condensed equations are not valid, compute the even forces that would give the robot, with all
// joints locked, the desired body acceleration.
void QpTermsWriter::write_even_forces(const Dynamics& dynamics, const BodyAcceleration& desired,
                                      const RobotState& state,
                                      const Eigen::Vector4d& share) noexcept {
  if (!terms_.has_condensed) {
    const FeetWrench wrench = feet_wrench(desired, robot_.mass(), dynamics, state);
    even_forces_ = even_forces(dynamics, wrench.force, wrench.moment, share);
    return;
  }
  Matrix6x12 A;
  Vector6 b;
  for (int k = 0; k < 2; ++k) {
    const BodyRows& rows = terms_.body[k];
    A.middleRows<3>(3 * k) = rows.A_force + rows.A_base * terms_.condensed.B;
    b.segment<3>(3 * k) = rows.b - rows.A_base * terms_.condensed.c;
  }
  even_forces_ = even_forces(A, b, share);
}

// The cost pulls the contact forces towards the even forces and towards the forces of the last
// tick. Both terms are quadratic, so their sum is one term towards the weighted mean.
void QpTermsWriter::write_forces(const Gains& gains, const Reference& reference,
                                 const FeetMatrix* previous) noexcept {
  Vector12 desired = even_forces_;
  if (reference.use_forces) {
    for (int leg = 0; leg < kLegs; ++leg) {
      desired.segment<3>(3 * leg) = reference.feet[leg].f_world;
    }
  }
  terms_.weight_force = gains.weight_force + gains.weight_smooth;
  const double previous_share = gains.weight_smooth / terms_.weight_force;
  terms_.forces = desired;
  if (previous != nullptr) terms_.forces += previous_share * (previous->reshaped() - desired);
}

void QpTermsWriter::write_posture(const Gains& gains, const RobotState& state,
                                  const Reference& reference) noexcept {
  terms_.has_posture = gains.weight_posture > 0.0;
  for (std::size_t k = 0; k < joints_.size(); ++k) {
    const int group = joints_[k].group;
    const double softness = group == kLegs ? 1.0 : terms_.foot_softness[group];
    // Cubed, so that the posture weight stays small while the softness of a foot is near 0. A
    // larger posture weight would outweigh the foot task.
    terms_.posture_weight[k] =
        std::max(gains.weight_posture, softness * softness * softness * gains.weight_posture_free);
    terms_.has_posture = terms_.has_posture || softness > 0.0;
  }
  if (terms_.has_posture) {
    posture_accelerations(gains, joints_, state, reference.posture, terms_.posture);
  }
}

Status QpTermsWriter::write_custom(const Dynamics& dynamics, const RobotState& state) noexcept {
  for (auto& [task, rows, b] : terms_.custom) {
    if (!task->write(state, rows) || !is_valid(rows, b.size(), robot_.nv()))
      return Status::kBadTask;
    // The QP uses the spatial acceleration of the base for the velocity that was passed to
    // Dynamics::update(). A user task uses it for the velocity after Dynamics::shift(). The two
    // differ by a_base_shift(), so rows.b is corrected by this difference.
    b = rows.b;
    b.noalias() -= rows.A_a.leftCols<3>() * dynamics.a_base_shift();
  }
  return Status::kOk;
}

}  // namespace surefoot
