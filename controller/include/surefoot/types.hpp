// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "surefoot/math.hpp"

/// The structs on the wires between the stages. Plain data; every one can be logged and replayed.
namespace surefoot {

/// What became of a tick. Anything but kOk is said here and never thrown.
enum class Status : int {
  kOk = 0,
  kWaiting,        ///< no valid state has come yet
  kNonFinite,      ///< a NaN or an infinity in a field that is used
  kImplausible,    ///< a used field is finite and beyond what the robot can do or measure
  kFallen,         ///< the base is tilted beyond the gain fall_tilt
  kBadReference,   ///< the reference has no unit quaternion, or no upward unit ground normal
  kWrongSize,      ///< q or v is not of the robot's size
  kBadQuaternion,  ///< a quaternion (the IMU's, or q's) is zero or far from unit length
  kStaleTick,      ///< tick did not advance
  kMaxIterations,  ///< the quadratic program hit its cap before our residual check passed
  kInfeasible,     ///< the solver called the program infeasible
  kSingular,       ///< a leg is too close to straight or to hip height for the condensed form
  kDamping         ///< latched: the motors brake until reset()
};
const char* to_string(Status status) noexcept;

/// Where the robot is and how it moves.
struct RobotState {
  /// Level at the origin, at rest. Throws surefoot::Error unless nq >= 7 and nv >= 6.
  explicit RobotState(int nq = 19, int nv = 18);
  Eigen::VectorXd q;  ///< Pinocchio's q: position, quaternion x y z w, joints
  Eigen::VectorXd v;  ///< Pinocchio's v: base twist in base axes, joint velocities
  /// Probability that each foot carries load, 0 .. 1, FR FL RR RL.
  Eigen::Vector4d contact = Eigen::Vector4d::Ones();
};

/// What one foot is asked to do, in the world frame of RobotState.
struct FootReference {
  bool stance = true;                 ///< false: swing, carries no force
  Vector3 p_world = Vector3::Zero();  ///< [m] where its contact point belongs (its anchor)
  Vector3 v_world = Vector3::Zero();  ///< [m/s]
  Vector3 a_world = Vector3::Zero();  ///< [m/s^2]
};

/// What the robot is asked to do, in the world frame of RobotState.
struct Reference {
  Vector3 p_com = Vector3::Zero();  ///< [m] centre of mass
  Vector3 v_com = Vector3::Zero();  ///< [m/s]
  Vector3 a_com = Vector3::Zero();  ///< [m/s^2] feed-forward
  Quaternion R_world_base = Quaternion::Identity();
  Vector3 w_world_base = Vector3::Zero();      ///< [rad/s] in world axes
  Vector3 alpha_world_base = Vector3::Zero();  ///< [rad/s^2] feed-forward, world axes
  std::array<FootReference, kLegs> feet;
  Vector3 ground_normal = Vector3::UnitZ();  ///< unit, pointing out of the ground
};

/// What the whole-body program decided.
struct Solution {
  explicit Solution(int nv = 18)
      : accelerations(Eigen::VectorXd::Zero(nv)), torques(Eigen::VectorXd::Zero(nv - 6)) {}
  Status status = Status::kWaiting;
  Eigen::VectorXd accelerations;           ///< shape (nv,), Pinocchio's order
  FeetMatrix forces = FeetMatrix::Zero();  ///< [N] ground on foot, world axes, FR FL RR RL
  Eigen::VectorXd torques;                 ///< [N.m] shape (nv - 6,), order of v[6:]
  int iterations = 0;                      ///< inner iterations of the solver
  double primal_residual = 0.0;            ///< our own check, in the program's scaling
  double dual_residual = 0.0;
};

}  // namespace surefoot
