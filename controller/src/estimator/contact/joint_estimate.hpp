// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "dynamics/dynamics.hpp"
#include "estimator/contact/joint_regression.hpp"

namespace surefoot {

/// Motion and torques of the legs from which JointEstimate::update() learns.
struct JointInput {
  const Dynamics& dynamics;      ///< with armature_error()
  const FeetMatrix& v_contact;   ///< velocities of the contact points, world axes [m/s]
  const Vector12& swing_torque;  ///< LegForces::swing_torque() [N.m]
  const Vector12& q;             ///< joint angles, SDK motor order [rad]
  const Vector12& stops;         ///< result of joint_stops()
};

/// Rotor inertia and friction of the joints, learnt from legs that swing.
///
/// No force acts on a foot in the air. A torque that the model does not explain is then caused by
/// a wrong armature or by friction of the joint (see JointRegression). Joints of one kind, those
/// with equal armature, torque limit and no-load speed in RobotConfig, share an estimate.
///
/// All terms of the equation pass the same filters: LegForces::kFilterTime, then a slower one.
/// Velocities and accelerations are differences of joint angles, because measured velocities have
/// the delay of the motor driver's filter, which looks like friction, and noise, which makes the
/// armature too small.
///
/// A foot is in the air if it moves fast against the slowest foot. Contact forces are not used,
/// because a wrong armature falsifies them.
///
/// Source of the regression on filtered signals: Khalil and Dombre 2002, "Modeling, identification
/// and control of robots", chapter 12. Real-time: update(), pause() and reset() yes.
class JointEstimate {
 public:
  explicit JointEstimate(const Robot& robot);

  /// Process one tick of a robot that steps.
  void update(const JointInput& input, double dt) noexcept;

  /// Forget the signals of the legs, because a tick is left out. The estimates stay.
  void pause() noexcept;

  /// Forget everything.
  void reset() noexcept;

  /// Learnt armature minus RobotConfig::armature [kg.m^2], SDK motor order; initially 0.
  const Vector12& armature_error() const noexcept { return armature_error_; }
  /// Learnt viscous friction [N.m.s/rad], SDK motor order; initially 0.
  const Vector12& damping() const noexcept { return damping_; }
  /// Learnt Coulomb friction [N.m], SDK motor order; initially 0.
  const Vector12& friction() const noexcept { return friction_; }

 private:
  // Terms of the equation for the joints of one leg.
  struct Terms {
    Vector3 torque = Vector3::Zero();  // [N.m] that the model without joint errors lacks
    Vector3 ddq = Vector3::Zero(), dq = Vector3::Zero(), sign = Vector3::Zero();
  };
  struct Leg {
    Vector3 last_q = Vector3::Zero();  // [rad] of the last tick
    Vector3 q = Vector3::Zero();       // [rad] low-passed
    Terms terms;                       // of this tick
    Terms low_passed;                  // since the foot has been in the air
    double fast_time = 0.0;            // [s] for which the foot has moved fast
  };
  void observe(int leg, const JointInput& input, double dt) noexcept;
  void learn(int leg, const Vector12& stops, double dt) noexcept;
  void take_results() noexcept;

  double air_speed_;      // [m/s] relative speed of a foot in the air
  Vector12 configured_;   // RobotConfig::armature
  Vector12 max_damping_;  // [N.m.s/rad]
  // Motors of one kind use the regression of the first of them.
  std::array<int, kMotors> first_of_kind_;
  std::array<JointRegression, kMotors> initial_, regressions_;
  std::array<Leg, kLegs> legs_;
  bool started_ = false;
  Vector12 armature_error_, damping_, friction_;
};

}  // namespace surefoot
