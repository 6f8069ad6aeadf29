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
  kDamping,        ///< latched: the motors brake until reset()
  kBadTask,        ///< a task of the user's failed, or wrote a number that is not finite
  kSaturated,      ///< the torques are good to send; a motor, or the power, is at its limit
  kDiverged        ///< the state estimate ran away: reports that no motion explains
};
const char* to_string(Status status) noexcept;
/// Does this status come with a command to send?
inline bool is_usable(Status status) noexcept {
  return status == Status::kOk || status == Status::kSaturated;
}

/// Where the robot is and how it moves.
struct RobotState {
  /// Level at the origin, at rest. Throws surefoot::Error unless nq >= 7 and nv >= 6.
  explicit RobotState(int nq = 19, int nv = 18);
  Eigen::VectorXd q;  ///< Pinocchio's q: position, quaternion x y z w, joints
  Eigen::VectorXd v;  ///< Pinocchio's v: base twist in base axes, joint velocities
  /// Probability that each foot carries load, 0 .. 1, FR FL RR RL.
  Eigen::Vector4d contact = Eigen::Vector4d::Ones();
  /// [N] force on the body from outside, through its centre of mass, world axes: a push, a payload.
  Vector3 f_external = Vector3::Zero();
  /// [N] the part of f_external that lasts: a payload. What holds the robot still counts with it.
  Vector3 f_sustained = Vector3::Zero();
  /// [N.m] moment on the body from outside about its centre of mass, world axes: a payload off it.
  Vector3 moment_external = Vector3::Zero();
  /// What is left of each foot's friction coefficient, 0 .. 1, FR FL RR RL: less while it slips.
  Eigen::Vector4d friction = Eigen::Vector4d::Ones();
};

/// What one foot is asked to do, in the world frame of RobotState.
struct FootReference {
  bool stance = true;                 ///< false: swing, carries no force
  double load = 1.0;                  ///< planned share 0 .. 1: ramp it to open or close a contact
  Vector3 p_world = Vector3::Zero();  ///< [m] where its contact point belongs (its anchor)
  Vector3 v_world = Vector3::Zero();  ///< [m/s]
  Vector3 a_world = Vector3::Zero();  ///< [m/s^2]
  Vector3 f_world = Vector3::Zero();  ///< [N] ground on foot; read when Reference::use_forces
};

/// Which point of the body the position task moves.
enum class BodyPoint { kCenterOfMass, kBase };

/// What the robot is asked to do, in the world frame of RobotState: a planner writes one each tick.
struct Reference {
  BodyPoint body_point = BodyPoint::kCenterOfMass;
  Vector3 p_com = Vector3::Zero();   ///< [m] centre of mass; read when it is the body point
  Vector3 v_com = Vector3::Zero();   ///< [m/s]
  Vector3 a_com = Vector3::Zero();   ///< [m/s^2] feed-forward
  Vector3 p_base = Vector3::Zero();  ///< [m] origin of the base; read when it is the body point
  Vector3 v_base = Vector3::Zero();  ///< [m/s] world axes
  Vector3 a_base = Vector3::Zero();  ///< [m/s^2] feed-forward, world axes
  Quaternion R_world_base = Quaternion::Identity();
  Vector3 w_world_base = Vector3::Zero();      ///< [rad/s] in world axes
  Vector3 alpha_world_base = Vector3::Zero();  ///< [rad/s^2] feed-forward, world axes
  Vector3 L_com = Vector3::Zero();     ///< [kg.m^2/s] angular momentum about the centre of mass
  Vector3 Ldot_com = Vector3::Zero();  ///< [N.m] feed-forward
  std::array<FootReference, kLegs> feet;
  bool use_forces = false;  ///< regularise towards feet[i].f_world instead of the even forces
  /// [rad] joints of the posture task, shape (nv - 6,), order of v[6:]; empty: the standing pose.
  Eigen::VectorXd posture;
  Vector3 ground_normal = Vector3::UnitZ();  ///< unit, pointing out of the ground
};

/// How the program eliminates the equations of motion.
enum class QpForm {
  kAuto,       ///< condensed where it holds, general elsewhere, with hysteresis
  kCondensed,  ///< contact forces alone; kSingular where a leg is near singular
  kGeneral     ///< accelerations and contact forces; any pose, any further joints
};
const char* to_string(QpForm form) noexcept;

/// What the whole-body program decided.
struct Solution {
  explicit Solution(int nv = 18)
      : accelerations(Eigen::VectorXd::Zero(nv)), torques(Eigen::VectorXd::Zero(nv - 6)) {}
  Status status = Status::kWaiting;
  QpForm form = QpForm::kAuto;             ///< which form was solved: kCondensed or kGeneral
  Eigen::VectorXd accelerations;           ///< shape (nv,), Pinocchio's order
  FeetMatrix forces = FeetMatrix::Zero();  ///< [N] ground on foot, world axes, FR FL RR RL
  Eigen::VectorXd torques;                 ///< [N.m] shape (nv - 6,), order of v[6:]
  double clipped_torque = 0.0;             ///< [N.m] most that the final clip took off a motor
  double torque_limit_violation = 0.0;  ///< most that torque limits had to give, share of tau_max
  double joint_limit_violation = 0.0;   ///< [rad/s^2] same for joint position and velocity limits
  double hold_down_violation = 0.0;     ///< [N] same for the force that keeps feet down
  int iterations = 0;                   ///< inner iterations of the solver
  double primal_residual = 0.0;         ///< our own check, in the program's scaling
  double dual_residual = 0.0;
};

}  // namespace surefoot
