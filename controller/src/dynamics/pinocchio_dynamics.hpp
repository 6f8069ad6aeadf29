// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "dynamics/dynamics_terms.hpp"
#include "surefoot/robot.hpp"

namespace surefoot {

/// Is the model a free base with four chains of three joints and nothing else?
bool has_three_joint_legs(const Robot& robot) noexcept;

/// Is the model's gravity (0, 0, -9.81)?
bool has_standard_gravity(const Robot& robot) noexcept;

/// The dynamics of a robot of any shape, by Pinocchio's algorithms. Real-time: update() yes.
class PinocchioDynamics {
 public:
  explicit PinocchioDynamics(const Robot& robot);
  ~PinocchioDynamics();

  /// @param q shape (nq,), @param v shape (nv,), @param ground_normal unit, world axes
  void update(const Eigen::VectorXd& q, const Eigen::VectorXd& v, const Vector3& ground_normal,
              DynamicsTerms& out) noexcept;

  /// Copy out what the general form needs of the last update; `terms` is its result, since shifted.
  void write_full(const DynamicsTerms& terms, FullDynamics& out) const noexcept;

 private:
  void update_leg(int leg, const Vector3& ground_normal, LegDynamics& out) noexcept;
  void update_com(const Eigen::VectorXd& v, DynamicsTerms& out) noexcept;

  struct Pinocchio;
  std::unique_ptr<Pinocchio> pinocchio_;
  Robot robot_;
};

}  // namespace surefoot
