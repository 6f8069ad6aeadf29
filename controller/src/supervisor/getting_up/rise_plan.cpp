// SPDX-License-Identifier: BSD-3-Clause
#include "supervisor/getting_up/rise_plan.hpp"

#include <algorithm>
#include <cmath>

#include "dynamics/dynamics.hpp"
#include "safety/holding_torques.hpp"
#include "surefoot/error.hpp"

namespace surefoot {

namespace {

// The constants are chosen by hand. benchmarks/get_up.py covers them: 1000 of 1000 dropped robots
// stand.
//
// [rad] Distance kept from the joint limits. Larger than 0.087, the SDK's default distance.
constexpr double kStopMargin = 0.1;
// Foot depth of the folded pose, as a share of the standing foot depth: just above the ground when
// the body lies.
constexpr double kFoldedDepth = 0.14;
// Hip angle outward for folding, as a share of the hip's outward joint limit. At larger angles the
// thigh touches the trunk.
constexpr double kHipOutwardShare = 0.6;
// [rad] Upper bound of that hip angle. It acts on robots whose outward hip limit exceeds
// 0.7 / 0.6 = 1.17 rad; the limit of a go2 is 1.05 rad.
constexpr double kMaxHipOutward = 0.7;
// Largest joint velocity, as a share of dq_max. On a1, go1, go2 and b1, kMaxRate is the stricter
// limit.
constexpr double kSpeedShare = 0.3;
// [1/s] Largest ds/dt. Slow on purpose. From folded to standing the path then takes 1.9 s:
// 1 / kMaxRate = 1.25 s at full rate, and the rest for acceleration and braking
// (docs/explanation/getting-up.md).
constexpr double kMaxRate = 0.8;
// [1/rad] K divided by (m g times standing foot depth). If smaller: legs sag by more than
// 3 degrees. If larger: legs that come free from an obstacle take more power, which grows with K.
constexpr double kStiffness = 1.05;
// [s] D / K. If smaller: legs that come free from an obstacle move too fast. If larger: delay and
// lag of the motors make the joints unstable.
constexpr double kDampingTime = 0.03;

/// Dynamics of the robot at rest at any joint angles, with a level base at the world origin. Joint
/// angles are in SDK motor order.
class LevelBaseDynamics {
 public:
  explicit LevelBaseDynamics(const Robot& robot)
      : robot_(robot), dynamics_(robot), state_(robot.nq(), robot.nv()) {}
  const Dynamics& at(const Vector12& joints) {
    for (int i = 0; i < kMotors; ++i) state_.q[robot_.motor_to_q()[i]] = joints[i];
    dynamics_.update(state_.q, state_.v, Vector3::UnitZ());
    return dynamics_;
  }
  Vector12 hold(const Vector12& joints) {
    return holding_torques(at(joints), robot_.mass(), state_, Eigen::Vector4d::Ones());
  }

 private:
  Robot robot_;
  Dynamics dynamics_;
  RobotState state_;
};

// Return the depth of the foot below the base [m].
double foot_depth(LevelBaseDynamics& pose, const Vector12& joints, int leg) {
  return -pose.at(joints).legs()[leg].p_world_contact.z();
}

// Set thigh and calf of a leg: the calf as in the folded pose, the foot straight below the hip.
void crouch_leg(int leg, const RisePlan& plan, Vector12& joints) {
  joints[3 * leg + 2] = plan.folded[3 * leg + 2];
  joints[3 * leg + 1] = -0.5 * joints[3 * leg + 2];
}

// Set thigh and calf of a leg. Bend the calf to kStopMargin from its stop. Then find by bisection
// the thigh angle at which the foot is behind the hip and `depth` [m] below the base. 40 bisections
// of at most 4 rad leave an error of 4e-12 rad.
void fold_leg(LevelBaseDynamics& pose, const RobotConfig& config, int leg, double depth,
              Vector12& joints) {
  const int thigh = 3 * leg + 1, calf = 3 * leg + 2;
  const bool negative = config.q_standing[calf] < 0.0;
  joints[calf] = negative ? config.q_lower[calf] + kStopMargin : config.q_upper[calf] - kStopMargin;
  double low = -0.5 * joints[calf];  // foot straight below the hip
  double high =
      negative ? config.q_upper[thigh] - kStopMargin : config.q_lower[thigh] + kStopMargin;
  for (int k = 0; k < 40; ++k) {
    joints[thigh] = 0.5 * (low + high);
    (foot_depth(pose, joints, leg) > depth ? low : high) = joints[thigh];
  }
}

// Compute the limits of ds/dt, the duration of the path, and its largest holding torque.
void plan_rates(const RobotConfig& config, LevelBaseDynamics& pose, double watts, RisePlan& plan) {
  for (int k = 0; k < RisePlan::kSamples; ++k) {
    const double s = double(k) / (RisePlan::kSamples - 1);
    const Vector12 direction = plan.direction_at(s), tau = pose.hold(plan.joints_at(s));
    double rate = kMaxRate;
    for (int i = 0; i < kMotors; ++i) {
      rate =
          std::min(rate, kSpeedShare * config.dq_max[i] / std::max(std::abs(direction[i]), 1e-9));
      plan.max_holding_share =
          std::max(plan.max_holding_share, std::abs(tau[i]) / config.tau_max[i]);
    }
    const double work = tau.cwiseProduct(direction).cwiseAbs().sum();  // [J] work per unit of s
    plan.rate[k] = std::min(rate, watts / work);
    plan.time += 1.0 / (plan.rate[k] * RisePlan::kSamples);
  }
}

}  // namespace

double RisePlan::rate_at(double s) const noexcept {
  const double x = std::clamp(s, 0.0, 1.0) * (kSamples - 1);
  const int k = std::min(static_cast<int>(x), kSamples - 2);
  return rate[k] + (x - k) * (rate[k + 1] - rate[k]);
}

double RisePlan::nearest(const Vector12& joints) const noexcept {
  double best = 0.0;
  for (int k = 1; k < kSamples; ++k) {
    const double s = double(k) / (kSamples - 1);
    if ((joints_at(s) - joints).norm() < (joints_at(best) - joints).norm()) best = s;
  }
  return best;
}

RisePlan plan_rise(const Robot& robot, double watts) {
  const RobotConfig& config = robot.config();
  if (robot.nv() != 6 + kMotors) {
    throw Error("robot '" + config.name + "': got nv = " + std::to_string(robot.nv()) +
                ", expected 18 to plan a rise");
  }
  LevelBaseDynamics pose(robot);
  RisePlan plan;
  plan.standing = plan.folded = plan.crouched = config.q_standing;
  plan.lower = config.q_lower.array() + kStopMargin;
  plan.upper = config.q_upper.array() - kStopMargin;
  double depth = 0.0;
  for (int leg = 0; leg < kLegs; ++leg) {
    const double standing = foot_depth(pose, plan.standing, leg);
    const double outward =
        pose.at(plan.standing).legs()[leg].p_world_contact.y() < 0.0 ? -1.0 : 1.0;
    const int hip = 3 * leg;
    plan.hip_outward_limit[hip] = outward < 0.0 ? plan.lower[hip] : plan.upper[hip];
    const double range = outward < 0.0 ? -config.q_lower[hip] : config.q_upper[hip];
    plan.hip_outward[hip] = outward * std::min(kMaxHipOutward, kHipOutwardShare * range);
    fold_leg(pose, config, leg, kFoldedDepth * standing, plan.folded);
    crouch_leg(leg, plan, plan.crouched);
    depth += standing / kLegs;
  }
  plan.stiffness = kStiffness * robot.mass() * kGravity * depth;
  plan.damping = kDampingTime * plan.stiffness;
  plan_rates(config, pose, watts, plan);
  return plan;
}

}  // namespace surefoot
