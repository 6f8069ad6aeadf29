// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/math.hpp"

namespace surefoot {

/// Recursive least squares for armature error e, viscous friction d and Coulomb friction c of one
/// kind of joint: torque = e ddq + d dq + c sign(dq).
///
/// Errors of the model are the same in every swing and do not average out. So result() is not the
/// plain estimate x, but
///   (S / sigma^2 + P_0^-1)^-1 S / sigma^2 x,
/// where S is the mean of regressor * regressor^T, sigma the standard deviation of the model error,
/// and P_0 the initial covariance. It is near x for a joint that moves much, and near 0 for a joint
/// that hardly moves. Real-time: yes.
class JointRegression {
 public:
  JointRegression() = default;
  /// @param tau_max torque limit of the joint [N.m]
  /// @param sigmas initial standard deviations of e [kg.m^2], d [N.m.s/rad], c [N.m]
  JointRegression(double tau_max, const Vector3& sigmas);

  /// Learn from one sample.
  /// @param regressor ddq [rad/s^2], dq [rad/s], sign(dq)
  /// @param torque that the model lacks [N.m]
  void learn(const Vector3& regressor, double torque, double dt) noexcept;

  /// Return e, d, c as explained above; each at most three initial standard deviations from 0.
  Vector3 result() const noexcept;

 private:
  double tau_max_ = 0.0;
  Vector3 initial_variances_ = Vector3::Zero();
  Vector3 x_ = Vector3::Zero();
  Matrix3 P_ = Matrix3::Zero();           // covariance
  Matrix3 excitation_ = Matrix3::Zero();  // mean of regressor * regressor^T over the memory
  double time_ = 0.0;                     // [s] of all samples, at most the memory
};

}  // namespace surefoot
