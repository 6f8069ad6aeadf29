// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dynamics/dynamics.hpp"
#include "surefoot/gains.hpp"

namespace surefoot {

/// Which foot carries load: footForceEst while it is alive, else the motors' torques.
///
/// footForceEst is zero on most real robots, and a stray count must not switch the source: it
/// counts as alive only after it has agreed with the torques that the robot is carried, and as dead
/// again when it denies that for as long. Real-time: yes.
class ContactEstimator {
 public:
  ContactEstimator(double weight) : weight_(weight) {}

  /// @param foot_force_est [N] FR FL RR RL
  /// @param tau_est [N.m] SDK motor order
  void update(const Gains& gains, const Dynamics& dynamics, const Vector12& tau_est,
              const std::array<std::int16_t, kLegs>& foot_force_est, const Vector3& normal,
              double dt) noexcept;

  /// Belief that each foot carries load, 0 .. 1; a change takes the dwell time.
  const Eigen::Vector4d& probability() const noexcept { return probability_; }
  /// Normal force per foot from the motors' torques [N].
  const Eigen::Vector4d& torque_force() const noexcept { return torque_force_; }
  bool foot_force_alive() const noexcept { return alive_; }

  void reset() noexcept { *this = ContactEstimator(weight_); }

 private:
  void judge_foot_force(const std::array<std::int16_t, kLegs>& force, double dt) noexcept;

  double weight_;
  bool alive_ = false;
  double contradiction_ =
      0.0;  // [s] for which the torques have contradicted what is held of the field
  std::array<bool, kLegs> loaded_{true, true, true, true};
  Eigen::Vector4d torque_force_ = Eigen::Vector4d::Zero();
  Eigen::Vector4d probability_ = Eigen::Vector4d::Ones();
};

}  // namespace surefoot
