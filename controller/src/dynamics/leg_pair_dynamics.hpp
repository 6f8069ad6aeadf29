// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dynamics/dynamics_terms.hpp"
#include "dynamics/generated/leg_dynamics.hpp"
#include "surefoot/robot.hpp"

namespace surefoot {

/// One value for each of two legs; the compiler maps it to one SSE2 or NEON register.
typedef double LegPair __attribute__((vector_size(16)));

/// Evaluates the generated leg dynamics for the four legs of a robot, two legs at a time.
///
/// Real-time: all functions except the constructor.
class LegPairDynamics {
 public:
  /// @param robot must satisfy QuadrupedDynamics::fits()
  explicit LegPairDynamics(const Robot& robot);

  /// Evaluate all legs.
  /// @param terms input: R_world_base, v_base and w_base
  /// @param g_base gravity in base axes [m/s^2]
  void evaluate(const Eigen::VectorXd& q, const Eigen::VectorXd& v, const DynamicsTerms& terms,
                const Vector3& g_base, const Vector3& ground_normal) noexcept;

  /// Sum the first kShared results of each leg over the four legs, entry by entry.
  void sum_over_legs(double (&sums)[leg_code::kShared]) const noexcept;

  /// Write the results of a leg to out.legs[leg].
  /// @param out in and out: R_world_base, p_world_base and w_base must be set before
  void read_leg(int leg, DynamicsTerms& out) const noexcept;

 private:
  void write_base(const DynamicsTerms& terms, const Vector3& g_base,
                  const Vector3& ground_normal) noexcept;
  void write_legs(const Eigen::VectorXd& q, const Eigen::VectorXd& v) noexcept;

  static constexpr int kPairs = kLegs / 2;
  LegPair leg_constants_[kPairs][leg_code::kPacked];
  LegPair base_inputs_[leg_code::kBase];
  LegPair leg_inputs_[kPairs][leg_code::kLeg];
  LegPair results_[kPairs][leg_code::kResults];
  double foot_radius_;
  std::array<int, kMotors> motor_to_q_, motor_to_v_;
};

}  // namespace surefoot
