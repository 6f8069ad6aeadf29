// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "surefoot/math.hpp"

/// Plain data types that the stages of a tick exchange. All of them can be logged and replayed.
namespace surefoot {

/// Result of a tick. A tick reports errors by its status and never throws.
enum class Status : int {
  kOk = 0,         ///< a command, or a solution, was computed
  kWaiting,        ///< no valid sample has arrived yet, or no tick has run
  kNonFinite,      ///< a used field is NaN or infinite, or above 1e4 in a LowState
  kImplausible,    ///< a used field is beyond what the robot can do or measure
  kFallen,         ///< the base is tilted beyond the gain fall_tilt
  kBadReference,   ///< the reference needs a unit quaternion and an upward unit ground normal
  kWrongSize,      ///< q, v or the posture does not have the robot's size
  kBadQuaternion,  ///< a quaternion (the IMU's, or q's) is zero or far from unit length
  kStaleTick,      ///< LowState::tick did not advance, or jumped ahead
  kMaxIterations,  ///< the solver found no solution that passes the residual check
  kInfeasible,     ///< the solver reported that the QP is infeasible
  kSingular,       ///< condensed form: a leg is nearly straight, or a foot near hip height
  kDamping,        ///< latched: the motors brake until reset()
  kBadTask,        ///< a custom task failed, or wrote invalid or far too heavy rows
  kSaturated,      ///< the command may be sent; a motor or the power is at its limit
  kDiverged,       ///< the state estimate diverged: no motion explains the samples
  // The sensor has been wrong since the first sample (unit, sign, order, or stuck): it contradicts
  // the other sensors or the robot's range. The motors brake until reset(). A wrong quaternion is
  // kBadQuaternion, or only a verdict in EstimatorReport.
  kWrongGyroscope,        ///< gyroscope: expected rad/s in IMU axes
  kWrongAccelerometer,    ///< accelerometer: expected m/s^2 in IMU axes, + 9.81 upwards at rest
  kWrongJointAngles,      ///< q: expected rad, order and signs of the SDK
  kWrongJointVelocities,  ///< dq: expected rad/s, order and signs of the SDK
  kWrongJointTorques      ///< tauEst: expected N.m, order and signs of the SDK
};
/// Return the name of a status, such as "max_iterations". Real-time: yes.
const char* to_string(Status status) noexcept;
/// Return whether a tick with this status gave a command to send. Real-time: yes.
inline bool is_usable(Status status) noexcept {
  return status == Status::kOk || status == Status::kSaturated;
}

/// Return whether a status names a sensor that has been wrong since the first sample. Real-time:
/// yes.
inline bool names_wrong_sensor(Status status) noexcept {
  return status >= Status::kWrongGyroscope && status <= Status::kWrongJointTorques;
}

/// State of the robot: pose, motion, contacts and external wrench.
struct RobotState {
  /// Create a state at rest, base level at the world origin. Throws surefoot::Error unless nq >= 7
  /// and nv >= 6.
  explicit RobotState(int nq = 19, int nv = 18);
  /// Pinocchio's q: position of the base in the world [m], quaternion x y z w from base to world
  /// axes, joint angles [rad].
  Eigen::VectorXd q;
  /// Pinocchio's v: linear [m/s] and angular [rad/s] velocity of the base in base axes, joint
  /// velocities [rad/s].
  Eigen::VectorXd v;
  /// Contact confidence of each foot, 0 .. 1, FR FL RR RL. At 0 the gains force_lost_contact and
  /// share_lost_contact limit the load of a stance foot; between 0 and 1 the limits are
  /// interpolated. To lift a foot, use FootReference::stance.
  Eigen::Vector4d contact = Eigen::Vector4d::Ones();
  /// [N] External force through the centre of mass, world axes: pushes and payload.
  Vector3 f_external = Vector3::Zero();
  /// [N] Sustained part of f_external, world axes: a payload. The torques that hold the robot
  /// include this part.
  Vector3 f_sustained = Vector3::Zero();
  /// [N.m] External moment about the centre of mass, world axes; the estimator reports its
  /// sustained part.
  Vector3 moment_external = Vector3::Zero();
  /// Share of RobotConfig::friction that each foot may use, 0 .. 1, FR FL RR RL. It is smaller
  /// while the foot slips.
  Eigen::Vector4d friction = Eigen::Vector4d::Ones();
};

/// Reference of one foot, in the world frame of RobotState.
struct FootReference {
  bool stance = true;                 ///< false: swing foot, planned without force
  double load = 1.0;                  ///< planned load 0 .. 1; ramp it to make or break contact
  Vector3 p_world = Vector3::Zero();  ///< [m] desired position of the contact point
  Vector3 v_world = Vector3::Zero();  ///< [m/s] desired velocity
  Vector3 a_world = Vector3::Zero();  ///< [m/s^2] feed-forward acceleration
  Vector3 f_world = Vector3::Zero();  ///< [N] desired, ground on foot; for use_forces
};

/// Point of the body that the position task moves.
enum class BodyPoint {
  kCenterOfMass,  ///< the centre of mass of the robot
  kBase           ///< the origin of the base
};

/// Desired motion of the robot in the world frame of RobotState. A planner writes one in each tick.
struct Reference {
  BodyPoint body_point = BodyPoint::kCenterOfMass;
  Vector3 p_com = Vector3::Zero();   ///< [m] centre of mass; used if it is the body point
  Vector3 v_com = Vector3::Zero();   ///< [m/s]
  Vector3 a_com = Vector3::Zero();   ///< [m/s^2] feed-forward
  Vector3 p_base = Vector3::Zero();  ///< [m] origin of the base; used if it is the body point
  Vector3 v_base = Vector3::Zero();  ///< [m/s] world axes
  Vector3 a_base = Vector3::Zero();  ///< [m/s^2] feed-forward, world axes
  Quaternion R_world_base = Quaternion::Identity();  ///< orientation of the base
  Vector3 w_world_base = Vector3::Zero();            ///< [rad/s] angular velocity, world axes
  Vector3 alpha_world_base = Vector3::Zero();        ///< [rad/s^2] feed-forward, world axes
  /// [kg.m^2/s] Angular momentum about the centre of mass, world axes; used if gain weight_momentum
  /// is above 0.
  Vector3 L_com = Vector3::Zero();
  Vector3 Ldot_com = Vector3::Zero();     ///< [N.m] feed-forward, world axes
  std::array<FootReference, kLegs> feet;  ///< FR FL RR RL
  /// True: the cost pulls the contact forces towards feet[i].f_world, not towards the even forces.
  bool use_forces = false;
  /// [rad] Joint angles of the posture task, shape (nv - 6,), order of v[6:]; empty: standing pose.
  Eigen::VectorXd posture;
  Vector3 ground_normal = Vector3::UnitZ();  ///< unit length, out of the ground, for all feet
};

/// Form of the whole-body QP: how the equations of motion are eliminated.
enum class QpForm {
  kAuto,       ///< condensed where it is valid, else general, with hysteresis
  kCondensed,  ///< variables: contact forces; kSingular where a leg is nearly singular
  kGeneral     ///< variables: accelerations and contact forces; any pose, further joints
};
/// Return the name of a form. Real-time: yes.
const char* to_string(QpForm form) noexcept;

/// Solution of the whole-body QP. If the status is neither kOk nor kSaturated, all fields other
/// than status, iterations and residuals keep the values of the last good tick.
struct Solution {
  explicit Solution(int nv = 18)
      : accelerations(Eigen::VectorXd::Zero(nv)), torques(Eigen::VectorXd::Zero(nv - 6)) {}
  Status status = Status::kWaiting;
  QpForm form = QpForm::kAuto;             ///< form that was solved: kCondensed or kGeneral
  Eigen::VectorXd accelerations;           ///< shape (nv,), Pinocchio's order, spatial in base axes
  FeetMatrix forces = FeetMatrix::Zero();  ///< [N] ground on foot, world axes, FR FL RR RL
  Eigen::VectorXd torques;                 ///< [N.m] shape (nv - 6,), order of v[6:]
  double clipped_torque = 0.0;             ///< [N.m] largest torque cut off at a motor limit
  double torque_limit_violation = 0.0;     ///< largest slack of torque limits, share of tau_max
  double joint_limit_violation = 0.0;      ///< [rad/s^2] largest slack of acceleration limits
  double hold_down_violation = 0.0;        ///< [N] largest slack of hold-down forces
  int iterations = 0;                      ///< changes of the active set plus ProxQP iterations
  double primal_residual = 0.0;            ///< largest violation, in the scaling of the QP
  double dual_residual = 0.0;              ///< of the gradient, in the scaling of the QP
};

}  // namespace surefoot
