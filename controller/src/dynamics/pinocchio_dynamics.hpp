// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "dynamics/dynamics_terms.hpp"
#include "surefoot/robot.hpp"

namespace surefoot {

/// Return whether the model is a free base with four chains of three joints and nothing else.
bool has_three_joint_legs(const Robot& robot) noexcept;

/// Return whether the gravity of the model is (0, 0, -9.81) m/s^2.
bool has_standard_gravity(const Robot& robot) noexcept;

/// Dynamics of a robot of any shape, computed by Pinocchio's crba() and nonLinearEffects().
///
/// Real-time: all functions except the constructor.
class PinocchioDynamics {
 public:
  explicit PinocchioDynamics(const Robot& robot);
  ~PinocchioDynamics();

  /// Compute all terms at a state.
  /// @param q configuration, shape (nq,)
  /// @param v velocity, shape (nv,)
  /// @param ground_normal unit length, world axes
  void update(const Eigen::VectorXd& q, const Eigen::VectorXd& v, const Vector3& ground_normal,
              DynamicsTerms& out) noexcept;

  /// Write the full matrices of the last update().
  /// @param terms result of that update(); shift() may have changed it since then
  void write_full(const DynamicsTerms& terms, FullDynamics& out) const noexcept;

 private:
  void update_leg(int leg, const Vector3& ground_normal, LegDynamics& out) noexcept;
  void update_com(const Eigen::VectorXd& v, DynamicsTerms& out) noexcept;

  struct Pinocchio;
  std::unique_ptr<Pinocchio> pinocchio_;
  Robot robot_;
};

}  // namespace surefoot
