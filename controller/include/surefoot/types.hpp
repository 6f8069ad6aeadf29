// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "surefoot/math.hpp"

/// Plain data types that the stages of a tick exchange. All of them can be logged and replayed.
namespace surefoot {

/// Result of a tick. A tick returns errors as a Status and never throws.
enum class Status : int {
  kOk = 0,       ///< a command, or a solution, was computed
  kWaiting,      ///< no valid sample has arrived yet, or no tick has run
  kNonFinite,    ///< a field that is read is NaN or infinite; LowState: or above 1e4 in magnitude
  kImplausible,  ///< a field that is read is beyond what the robot can do or measure
  kFallen,       ///< the base is tilted beyond the gain fall_tilt
  /// The quaternion or the ground normal of the reference is not of unit length, or the normal does
  /// not point up. Controller: also, the planner failed, or wrote a number that is not finite.
  kBadReference,
  kWrongSize,      ///< q, v or the posture does not have the robot's size
  kBadQuaternion,  ///< the quaternion of the IMU or of q is zero or far from unit length
  kStaleTick,      ///< LowState::tick did not advance, or jumped ahead
  kMaxIterations,  ///< the solver found no solution with small enough residuals
  kInfeasible,     ///< the solver reported that the QP is infeasible
  kSingular,       ///< condensed form: a leg is nearly straight, or a foot near hip height
  kDamping,        ///< damping is latched: the motors damp until reset()
  kBadTask,        ///< a custom task failed, or wrote invalid rows or rows with too large weights
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
  /// Contact confidence of each foot, 0 .. 1, FR FL RR RL. While the confidence of a stance foot is
  /// 0, the gains force_lost_contact and share_lost_contact limit its load; between 0 and 1 the
  /// limits are interpolated. To lift a foot, use FootReference::stance.
  Eigen::Vector4d contact = Eigen::Vector4d::Ones();
  /// [N] External force through the centre of mass, world axes: pushes and payload.
  Vector3 f_external = Vector3::Zero();
  /// [N] Sustained part of f_external, world axes: a payload. The holding torques include this
  /// force.
  Vector3 f_sustained = Vector3::Zero();
  /// [N.m] External moment about the centre of mass, world axes. The estimator sets the sustained
  /// part only.
  Vector3 moment_external = Vector3::Zero();
  /// Share of RobotConfig::friction that each foot may use, 0 .. 1, FR FL RR RL. It is below 1 on
  /// ground with less friction (EstimatorReport::friction), and smaller for a foot that slips.
  Eigen::Vector4d friction = Eigen::Vector4d::Ones();
  /// [kg.m^2] Rotor inertia of each joint as learnt by the estimator, minus RobotConfig::armature,
  /// SDK motor order. The sum of both must not be negative.
  Vector12 armature_error = Vector12::Zero();
  /// [N.m.s/rad] Viscous friction of each joint that the controllers compensate, SDK motor order, 0
  /// or more. The estimator sets it while the robot steps; a standing robot needs its damping.
  Vector12 joint_damping = Vector12::Zero();
  /// [N.m] Coulomb friction of each joint that the controllers compensate, likewise.
  Vector12 joint_friction = Vector12::Zero();
};

/// Reference of one foot, in the world frame of RobotState.
struct FootReference {
  bool stance = true;  ///< true: stance foot; false: swing foot, planned without force
  double load = 1.0;   ///< planned load, 0 .. 1; ramp it to make or break contact
  /// Smallest contact confidence that the force limits assume, 0 .. 1: a planner that knows when
  /// the foot lands sets it. 0: the limits follow RobotState::contact.
  double min_contact = 0.0;
  Vector3 p_world = Vector3::Zero();  ///< [m] desired position of the contact point
  Vector3 v_world = Vector3::Zero();  ///< [m/s] desired velocity of the contact point
  Vector3 a_world = Vector3::Zero();  ///< [m/s^2] feed-forward acceleration of the contact point
  Vector3 f_world = Vector3::Zero();  ///< [N] desired ground force; used if use_forces is true
};

/// Point of the body that the position task moves.
enum class BodyPoint {
  kCenterOfMass,  ///< the centre of mass of the robot
  kBase           ///< the origin of the base
};

/// Desired motion of the robot in the world frame of RobotState. A planner writes a Reference in
/// each tick.
struct Reference {
  BodyPoint body_point = BodyPoint::kCenterOfMass;  ///< point that the position task moves
  Vector3 p_com = Vector3::Zero();                  ///< [m] centre of mass; used for kCenterOfMass
  Vector3 v_com = Vector3::Zero();                  ///< [m/s] velocity of the centre of mass
  Vector3 a_com = Vector3::Zero();   ///< [m/s^2] feed-forward acceleration of the centre of mass
  Vector3 p_base = Vector3::Zero();  ///< [m] origin of the base; used for kBase
  Vector3 v_base = Vector3::Zero();  ///< [m/s] velocity of the base origin, world axes
  Vector3 a_base = Vector3::Zero();  ///< [m/s^2] feed-forward acceleration, base origin, world axes
  Quaternion R_world_base = Quaternion::Identity();  ///< orientation of the base in the world
  Vector3 w_world_base = Vector3::Zero();            ///< [rad/s] angular velocity, world axes
  Vector3 alpha_world_base = Vector3::Zero();  ///< [rad/s^2] feed-forward acceleration, world axes
  /// [kg.m^2/s] Angular momentum about the centre of mass, world axes; used if gain weight_momentum
  /// is above 0.
  Vector3 L_com = Vector3::Zero();
  Vector3 Ldot_com = Vector3::Zero();     ///< [N.m] feed-forward rate of L_com, world axes
  std::array<FootReference, kLegs> feet;  ///< references of the feet, FR FL RR RL
  /// True: the QP regularises the forces towards feet[i].f_world. False: towards the even forces.
  bool use_forces = false;
  /// [rad] Joint angles of the posture task, shape (nv - 6,), order of v[6:]; empty: standing pose.
  Eigen::VectorXd posture;
  /// True: feet are about to step. The QP then has no priorities at support edges, and the tilt
  /// weight, joint limit rate and hold-down of a walking robot.
  bool stepping = false;
  /// Ground normal, the same for all feet: unit length, pointing out of the ground.
  Vector3 ground_normal = Vector3::UnitZ();
};

/// Form of the whole-body QP: which quantities are its variables.
enum class QpForm {
  kAuto,  ///< kCondensed while this form is valid, else kGeneral, with hysteresis
  /// The variables are the contact forces. If a leg is nearly singular, the status is
  /// Status::kSingular.
  kCondensed,
  /// The variables are the accelerations and contact forces. Valid for any pose and for further
  /// joints.
  kGeneral
};
/// Return the name of a form, such as "condensed". Real-time: yes.
const char* to_string(QpForm form) noexcept;

/// Solution of the whole-body QP. If the status is neither kOk nor kSaturated, all fields other
/// than status, iterations and residuals keep the values of the last good tick.
struct Solution {
  /// Create a solution of zeros for a robot with nv velocities.
  explicit Solution(int nv = 18)
      : accelerations(Eigen::VectorXd::Zero(nv)), torques(Eigen::VectorXd::Zero(nv - 6)) {}
  Status status = Status::kWaiting;  ///< result of the tick
  QpForm form = QpForm::kAuto;       ///< form that was solved: kCondensed or kGeneral
  /// Generalised accelerations, shape (nv,), Pinocchio's order; that of the base is spatial, in
  /// base axes.
  Eigen::VectorXd accelerations;
  FeetMatrix forces = FeetMatrix::Zero();  ///< [N] ground force on each foot, world axes
  Eigen::VectorXd torques;                 ///< [N.m] joint torques, shape (nv - 6,), order of v[6:]
  double clipped_torque = 0.0;             ///< [N.m] largest amount clipped at a motor limit
  double torque_limit_violation = 0.0;     ///< largest slack of the torque limits, share of tau_max
  /// [rad/s^2] Largest slack of the joint position and velocity limits, as a joint acceleration.
  double joint_limit_violation = 0.0;
  double hold_down_violation = 0.0;  ///< [N] largest slack of the hold-down forces
  int iterations = 0;                ///< changes of the active set plus ProxQP iterations
  double primal_residual = 0.0;      ///< largest violation of a constraint of the scaled QP
  double dual_residual = 0.0;  ///< largest entry of the gradient of the scaled QP's Lagrangian
};

}  // namespace surefoot
