// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dynamics/dynamics.hpp"
#include "tasks/body_acceleration.hpp"
#include "wbc/qp_terms.hpp"
#include "wbc/qp_units.hpp"

namespace surefoot {

/// Computes the QP's terms (tasks, weights, limits) from state, reference and gains.
/// Real-time: write() yes.
class QpTermsWriter {
 public:
  explicit QpTermsWriter(const Robot& robot);

  /// Add a user task with this number of rows. Real-time: no.
  void add_task(std::shared_ptr<Task> task, int rows);

  /// Write the terms of one tick.
  /// @param foot_softness softness of each foot, from FormSelector, 0 .. 1
  /// @param previous contact forces of the last tick [N], shape (3, 4); null if there are none
  /// @return kOk, or kBadTask if a user task failed or wrote invalid rows
  Status write(const Gains& gains, const Dynamics& dynamics, const RobotState& state,
               const Reference& reference, const Eigen::Vector4d& foot_softness,
               const FeetMatrix* previous) noexcept;

  const QpTerms& terms() const noexcept { return terms_; }
  void set_torque_share(const Vector12& share) noexcept { torque_share_ = share; }
  const Vector12& torque_share() const noexcept { return torque_share_; }

 private:
  void write_body(const Gains& gains, const Dynamics& dynamics, const RobotState& state,
                  const Reference& reference, double fade) noexcept;
  void write_even_forces(const Dynamics& dynamics, const BodyAcceleration& desired,
                         const RobotState& state, const Eigen::Vector4d& share) noexcept;
  void write_forces(const Gains& gains, const Reference& reference,
                    const FeetMatrix* previous) noexcept;
  void write_posture(const Gains& gains, const RobotState& state,
                     const Reference& reference) noexcept;
  Status write_custom(const Dynamics& dynamics, const RobotState& state) noexcept;

  Robot robot_;
  QpUnits units_;
  JointTable joints_;
  QpTerms terms_;
  Vector12 even_forces_ = Vector12::Zero();
  // Usable share of each motor's torque, SDK motor order.
  Vector12 torque_share_ = Vector12::Ones();
};

}  // namespace surefoot
