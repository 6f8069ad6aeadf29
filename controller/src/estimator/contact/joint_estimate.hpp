// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "dynamics/dynamics.hpp"

namespace surefoot {

/// Motion and torques of the legs of which JointEstimate::update() learns.
struct JointInput {
  const Dynamics& dynamics;      ///< with the joint errors learnt so far
  const FeetMatrix& v_contact;   ///< velocities of the contact points, world axes [m/s]
  const Vector12& swing_torque;  ///< LegForces::swing_torque() [N.m]
  const Vector12& q;             ///< joint angles, SDK motor order [rad]
};

/// Rotor inertia and friction of the joints, learnt from legs that swing.
///
/// No force acts on a foot in the air, so the torque that the model does not explain is that of
/// a wrong armature and of friction in the joint:
///   missing torque = e ddq + d dq + c sign(dq).
/// Recursive least squares estimate e, d and c. The same joint of the four legs has the same motor,
/// so all legs teach one estimate for hips, one for thighs and one for calves, or fewer: joints
/// with the same armature and torque limit in RobotConfig share an estimate.
///
/// All terms of the equation pass the same filters: LegForces::kFilterTime, then a slower one.
/// The accelerations are differences of joint angles. Joint velocities have the delay of the
/// driver's filter, which a regression takes for friction, and their noise, which would make the
/// armature too small.
///
/// A foot that moves fast against the slowest foot is in the air. This needs no contact forces:
/// a wrong armature falsifies the forces that the torques give. A fast foot may also hit something,
/// so a sample that the estimate does not explain by a few standard deviations does not count.
///
/// Errors of the model do not average out over many swings. An estimate whose joint hardly moves
/// contains little else, so it is reduced: the result is the estimate of a single measurement with
/// the mean excitation, a standard deviation of kModelSigma, and the initial variances.
///
/// Source of the regression on filtered signals: Khalil and Dombre 2002, "Modeling, identification
/// and control of robots", chapter 12. Real-time: update() yes.
class JointEstimate {
 public:
  explicit JointEstimate(const Robot& robot);

  /// Process one tick.
  /// @param input computed with the joint errors of `state`
  /// @param state armature_error, joint_damping and joint_friction are written
  void update(const JointInput& input, RobotState& state, double dt) noexcept;

  void reset() noexcept;

 private:
  // Recursive least squares of all joints with the same motor.
  struct Regression {
    Vector3 x = Vector3::Zero();  // [kg.m^2], [N.m.s/rad], [N.m]
    Matrix3 P = Matrix3::Zero();  // covariance
    // Mean of regressor * regressor^T over the memory.
    Matrix3 excitation = Matrix3::Zero();
    double time = 0.0;  // [s] of swing; at most the memory
  };
  // Terms of the equation for the joints of one leg.
  struct Terms {
    Vector3 missing = Vector3::Zero();  // [N.m] without the joint errors
    Vector3 ddq = Vector3::Zero(), dq = Vector3::Zero(), sign = Vector3::Zero();
  };
  struct Leg {
    Vector3 q = Vector3::Zero();   // [rad] low-passed
    Vector3 dq = Vector3::Zero();  // [rad/s] derivative of q
    double fast_time = 0.0;        // [s] for which the foot has moved fast
    Terms low_passed;              // since the foot has been in the air
  };
  Terms terms(int leg, const JointInput& input, const RobotState& state,
              const Vector3& ddq) const noexcept;
  void learn_from_swing(int leg, const Terms& terms, double dt) noexcept;
  Vector3 certain_part(int kind) const noexcept;
  void learn(int joint, const Vector3& regressor, double torque, double dt) noexcept;

  double air_speed_;     // [m/s] relative speed of a foot in the air
  Vector12 configured_;  // RobotConfig::armature
  Vector3 tau_max_;      // [N.m] hip, thigh, calf
  Vector3 max_damping_;  // [N.m.s/rad] hip, thigh, calf
  // Initial standard deviations: armature, damping, friction; columns: hip, thigh, calf.
  Matrix3 initial_sigma_;
  std::array<int, kLegJoints> kind_;  // index into regressions_: hip, thigh, calf
  std::array<Regression, kLegJoints> regressions_;
  std::array<Leg, kLegs> legs_;
  bool started_ = false;
};

}  // namespace surefoot
