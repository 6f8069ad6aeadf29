// SPDX-License-Identifier: BSD-3-Clause
#include "surefoot/types.hpp"

#include "surefoot/error.hpp"

namespace surefoot {

RobotState::RobotState(int nq, int nv) {
  if (nq < 7 || nv < 6) {
    throw Error("RobotState: got nq = " + std::to_string(nq) + ", nv = " + std::to_string(nv) +
                ", expected nq >= 7 and nv >= 6 (19 and 18 for a quadruped)");
  }
  q = Eigen::VectorXd::Zero(nq);
  v = Eigen::VectorXd::Zero(nv);
  q[6] = 1.0;
}

const char* to_string(Status status) noexcept {
  switch (status) {
    case Status::kOk:
      return "ok";
    case Status::kWaiting:
      return "waiting";
    case Status::kNonFinite:
      return "non_finite";
    case Status::kImplausible:
      return "implausible";
    case Status::kFallen:
      return "fallen";
    case Status::kBadReference:
      return "bad_reference";
    case Status::kWrongSize:
      return "wrong_size";
    case Status::kBadQuaternion:
      return "bad_quaternion";
    case Status::kStaleTick:
      return "stale_tick";
    case Status::kMaxIterations:
      return "max_iterations";
    case Status::kInfeasible:
      return "infeasible";
    case Status::kSingular:
      return "singular";
    case Status::kDamping:
      return "damping";
    case Status::kBadTask:
      return "bad_task";
    case Status::kSaturated:
      return "saturated";
    case Status::kDiverged:
      return "diverged";
    case Status::kWrongGyroscope:
      return "wrong_gyroscope";
    case Status::kWrongAccelerometer:
      return "wrong_accelerometer";
    case Status::kWrongJointAngles:
      return "wrong_joint_angles";
    case Status::kWrongJointVelocities:
      return "wrong_joint_velocities";
    case Status::kWrongJointTorques:
      return "wrong_joint_torques";
  }
  return "unknown";
}

const char* to_string(QpForm form) noexcept {
  switch (form) {
    case QpForm::kAuto:
      return "auto";
    case QpForm::kCondensed:
      return "condensed";
    case QpForm::kGeneral:
      return "general";
  }
  return "unknown";
}

}  // namespace surefoot
