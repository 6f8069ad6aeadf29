// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dynamics/dynamics_terms.hpp"
#include "dynamics/generated/leg_dynamics.hpp"
#include "surefoot/robot.hpp"

namespace surefoot {

/// Two legs side by side; the compiler makes it one SSE2 or NEON register.
typedef double LegPair __attribute__((vector_size(16)));

/// The generated code's data for the four legs of one robot. Real-time: all but the constructor.
class LegPairDynamics {
 public:
  /// @param robot one that QuadrupedDynamics fits
  explicit LegPairDynamics(const Robot& robot);

  /// Run the code.
  /// @param terms whose R_world_base, v_base and w_base are this tick's
  /// @param g_base gravity in base axes [m/s^2]
  void evaluate(const Eigen::VectorXd& q, const Eigen::VectorXd& v, const DynamicsTerms& terms,
                const Vector3& g_base, const Vector3& ground_normal) noexcept;

  /// Results that are added up over the legs, entry by entry.
  void sum_over_legs(double (&sums)[leg_code::kShared]) const noexcept;

  /// @param out whose R_world_base and p_world_base are this tick's
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
