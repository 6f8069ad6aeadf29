// SPDX-License-Identifier: BSD-3-Clause
#include "tick/motion_check.hpp"

#include <algorithm>
#include <cmath>

#include "dynamics/dynamics.hpp"
#include "estimator/imu/imu_filter_input.hpp"
#include "low_level/low_state_check.hpp"

namespace surefoot {

namespace {

// [s] Time constant of the displacements: older motion fades. Chosen. If smaller: slow motion does
// not reach the tolerances. If larger: the drift by a gyroscope's bias comes closer to them.
constexpr double kMemory = 0.1;
// [s] The same of the turns that outvote the legs. Chosen. If smaller: a robot with exchanged legs
// falls so slowly at first that its fall is found late. If larger: feet that creep come closer to
// the tolerance.
constexpr double kLongMemory = 0.5;
// [rad] Differences that are no contradiction, per joint and of a turn by gyroscope and quaternion.
// Derived: three times the noise of velocities and the bias of a gyroscope give 1.5 and 5 mrad
// within kMemory. Twice the tolerance is the smallest motion at which a sensor that reads zero is
// found.
constexpr double kJointTolerance = 0.005;
constexpr double kTurnTolerance = 0.02;
// [foot radius] Height by which soft soles and soft ground change below one side of the robot when
// its load changes. The body turns with them, and the legs cannot measure that. Chosen. If smaller:
// 1 of 128 pushed stands on soles that yield by a quarter of the radius is an alarm at 0.25, none
// at 0.5. If larger: at 1.0 a b1 with exchanged legs has begun to fall before it is found.
constexpr double kSoleHeight = 0.6;
// [larger displacement] Difference that is no contradiction. Chosen. Larger than scale errors and
// delays; smaller than 0.9, a sensor in units of g. 200 healthy starts of
// benchmarks/sensor_matrix.py reach half of both tolerances.
constexpr double kShare = 0.5;
// [tolerance] Displacement at which sensors that do not contradict each other agree. Derived:
// larger than 1 / (0.9 - kShare) = 2.5, the displacement at which a sensor in units of g
// contradicts.
constexpr double kMotion = 3.0;
// [rad] Change of an angle in one sample, beyond the displacement by dq, from which it has jumped.
// Equal to JointMonitor::kMaxJump.
constexpr double kMaxJump = 0.08;
// [rad] Clamps of the difference that one sample adds, so that a wrong sample alone is no
// contradiction. Chosen: below the tolerances.
constexpr double kMaxJointStep = 0.01;
constexpr double kMaxTurnStep = 0.005;

template <typename Vector>
bool contradict(const Vector& a, const Vector& b, double tolerance) noexcept {
  return (a - b).norm() > tolerance + kShare * std::max(a.norm(), b.norm());
}

// Return the turn [rad] by soft soles: their height over the shorter side of the stance.
double turn_by_soles(const Dynamics& dynamics, double foot_radius) noexcept {
  const FeetMatrix p = contact_points(dynamics);
  const double width = std::min((p.col(FL_) - p.col(FR_)).norm(), (p.col(FL_) - p.col(RL_)).norm());
  return kSoleHeight * foot_radius / std::max(width, foot_radius);
}

template <typename Vector>
Vector clamped(const Vector& values, double limit) noexcept {
  return values.cwiseMax(-limit).cwiseMin(limit);
}

// Return the share of older displacements that a sample keeps.
double share_kept(double dt, double memory) noexcept { return 1.0 - std::min(dt / memory, 1.0); }

}  // namespace

Status MotionCheck::update(const LowState& low_state, const RobotConfig& config,
                           const StateEstimator& estimator, bool feet_stand, double dt) noexcept {
  read(low_state, config, estimator, dt);
  if (!feet_stand) turns_ = long_turns_ = Turns();
  const Status turns = turns_done_ ? Status::kOk : judge_turns(config, estimator);
  const Status joints = joints_done_ ? Status::kOk : judge_joints(estimator);
  return joints != Status::kOk ? joints : turns;
}

void MotionCheck::read(const LowState& low_state, const RobotConfig& config,
                       const StateEstimator& estimator, double dt) noexcept {
  Vector12 q, dq;
  for (int i = 0; i < kMotors; ++i) {
    q[i] = low_state.motorState[i].q;
    dq[i] = low_state.motorState[i].dq;
  }
  const std::array<float, 4> wxyz = low_state.imu.quaternion;  // packed: not aligned
  const std::array<float, 3> rates = low_state.imu.gyroscope;
  const Quaternion R_base_imu = quaternion_wxyz(config.quat_base_imu);
  const Quaternion quaternion =
      Quaternion(wxyz[0], wxyz[1], wxyz[2], wxyz[3]).normalized() * R_base_imu.conjugate();
  const bool had_quaternion = has_quaternion_;
  has_quaternion_ = has_unit_quaternion(low_state.imu);
  Vector3 w_legs = Vector3::Zero();
  if (started_) add_joints(q - q_last_, dt * dq, share_kept(dt, kMemory));
  if (started_ && has_quaternion_ && had_quaternion &&
      rate_from_legs(estimator.dynamics(), estimator.state().contact, w_legs)) {
    const Vector3 w = R_base_imu * Vector3(rates[0], rates[1], rates[2]);
    const Vector3 beyond_legs = clamped<Vector3>(dt * (w - w_legs), kMaxTurnStep);
    const Vector3 by_quaternion = log_so3(quaternion_last_.conjugate() * quaternion);
    turns_.add(by_quaternion, dt * w_legs, beyond_legs, share_kept(dt, kMemory));
    long_turns_.add(by_quaternion, dt * w_legs, beyond_legs, share_kept(dt, kLongMemory));
  }
  q_last_ = q;
  quaternion_last_ = quaternion;
  started_ = true;
}

void MotionCheck::Turns::add(const Vector3& by_quaternion, const Vector3& by_legs,
                             const Vector3& beyond_legs, double keep) noexcept {
  gyroscope = keep * gyroscope + by_legs + beyond_legs;
  quaternion = keep * quaternion + by_quaternion;
  legs = keep * legs + by_legs;
}

// Add one sample's displacements. Older ones fade by `keep`.
void MotionCheck::add_joints(const Vector12& by_q, const Vector12& by_dq, double keep) noexcept {
  by_q_ *= keep;
  by_dq_ *= keep;
  const Vector12 beyond_q = by_dq - by_q;
  q_has_changed_ = q_has_changed_ || !by_q.isZero(0.0);
  if (beyond_q.cwiseAbs().maxCoeff() > kMaxJump) return;
  by_q_ += by_q;
  by_dq_ += by_q + clamped<Vector12>(beyond_q, kMaxJointStep);
}

Status MotionCheck::judge_turns(const RobotConfig& config,
                                const StateEstimator& estimator) noexcept {
  const double soles = turn_by_soles(estimator.dynamics(), config.foot_radius);
  const Turns& now = turns_;
  const Turns& past = long_turns_;
  const bool quaternion = contradict(now.gyroscope, now.quaternion, kTurnTolerance);
  if (quaternion && contradict(now.gyroscope, now.legs, kTurnTolerance) &&
      !contradict(now.quaternion, now.legs, kTurnTolerance)) {
    return Status::kWrongGyroscope;
  }
  const bool legs = contradict(past.gyroscope, past.legs, kTurnTolerance + soles);
  if (legs && !quaternion && contradict(past.quaternion, past.legs, kTurnTolerance + soles)) {
    return wrong_joints(estimator);
  }
  turns_done_ = !quaternion && !legs && past.gyroscope.norm() > kMotion * (kTurnTolerance + soles);
  return Status::kOk;
}

Status MotionCheck::judge_joints(const StateEstimator& estimator) noexcept {
  const double tolerance = kJointTolerance * std::sqrt(static_cast<double>(kMotors));
  if (contradict(by_q_, by_dq_, tolerance)) return wrong_joints(estimator);
  joints_done_ = by_q_.norm() > kMotion * tolerance;
  return Status::kOk;
}

// Return which of q and dq is wrong: with right displacements, the feet turn as the gyroscope says.
// A wrong unit of q is outside the joint ranges (FirstSamples), so without a turn dq is wrong.
Status MotionCheck::wrong_joints(const StateEstimator& estimator) const noexcept {
  if (!q_has_changed_) return Status::kWrongJointAngles;
  if (turns_.gyroscope.isZero(0.0)) return Status::kWrongJointVelocities;  // no turn was compared
  const Dynamics& dynamics = estimator.dynamics();
  const Vector12 difference = by_q_ - by_dq_;
  FeetMatrix motion;
  for (int leg = 0; leg < kLegs; ++leg) {
    motion.col(leg) = dynamics.legs()[leg].J_leg * difference.segment<3>(kLegJoints * leg);
  }
  Vector3 turn;
  if (!turn_of_feet(dynamics, estimator.state().contact, motion, turn)) {
    return Status::kWrongJointVelocities;
  }
  const Vector3 by_legs_q = turns_.legs - dynamics.R_world_base().transpose() * turn;
  const bool q_fits =
      (turns_.gyroscope - by_legs_q).norm() < (turns_.gyroscope - turns_.legs).norm();
  return q_fits ? Status::kWrongJointVelocities : Status::kWrongJointAngles;
}

}  // namespace surefoot
