// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "surefoot/robot.hpp"

namespace surefoot {

/// Motion and torques of the legs of which ArmatureEstimate::update() learns.
struct ArmatureInput {
  const FeetMatrix& v_contact;     ///< velocities of the contact points, world axes [m/s]
  const Vector12& missing_torque;  ///< LegForces::missing_torque() [N.m]
  const Vector12& ddq;             ///< LegForces::ddq() [rad/s^2]
  const Vector12& dq;              ///< joint velocities, SDK motor order [rad/s]
};

/// Rotor inertia of the joints, learnt from legs that swing.
///
/// No force acts on a foot in the air, so the torque that the model does not explain is that of
/// a wrong armature and of friction in the joint:
///   missing torque = e ddq + d dq + c sign(dq).
/// Recursive least squares estimate e, d and c. The same joint of the four legs has the same motor,
/// so all legs teach one estimate for hips, one for thighs and one for calves, or fewer: joints
/// with the same armature and torque limit in RobotConfig share an estimate.
///
/// The missing torque contains the noise of ddq, multiplied by the inertia of the joint. A
/// regression on such a ddq finds an armature that is too small. So all terms of the equation pass
/// the same low-pass, which the noise of differentiated encoders does not pass.
///
/// A foot that moves fast against the slowest foot is in the air. This needs no contact forces:
/// a wrong armature falsifies the forces that the torques give. The torque of one sample counts
/// only up to a few standard deviations, because a fast foot may also hit something.
///
/// Source of the regression on filtered signals: Khalil and Dombre 2002, "Modeling, identification
/// and control of robots", chapter 12. Real-time: update() yes.
class ArmatureEstimate {
 public:
  explicit ArmatureEstimate(const Robot& robot);

  /// Process one tick.
  void update(const ArmatureInput& input, double dt) noexcept;

  /// Learnt armature minus RobotConfig::armature, SDK motor order [kg.m^2]; initially 0. The
  /// learnt armature is never negative.
  const Vector12& error() const noexcept { return error_; }

  void reset() noexcept;

 private:
  // Recursive least squares of all joints with the same motor.
  struct Regression {
    Vector3 x = Vector3::Zero();  // [kg.m^2], [N.m.s/rad], [N.m]
    Matrix3 P = Matrix3::Zero();  // covariance
  };
  // Terms of the equation of one joint, low-passed since its foot has been in the air.
  struct Terms {
    Vector3 regressor = Vector3::Zero();
    double missing = 0.0;  // [N.m] with RobotConfig::armature
  };
  void filter(int motor, const ArmatureInput& input, double dt) noexcept;
  void learn(int motor, double dt) noexcept;
  Vector3 initial_variances(int kind) const noexcept;

  double air_speed_;                  // [m/s] relative speed of a foot in the air
  Vector12 configured_;               // RobotConfig::armature
  Vector3 tau_max_;                   // [N.m] hip, thigh, calf
  Vector3 inertia_;                   // [kg.m^2] in the standing pose: hip, thigh, calf
  std::array<int, kLegJoints> kind_;  // index into regressions_: hip, thigh, calf
  std::array<Regression, kLegJoints> regressions_;
  std::array<Terms, kMotors> terms_;
  Vector12 error_ = Vector12::Zero();
};

}  // namespace surefoot
