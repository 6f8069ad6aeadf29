// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <random>

#include "robot_states.hpp"

/// A robot near its limits: weak motors, joints with little range.
inline surefoot::Robot tight_limit_quadruped(double torque, double room) {
  surefoot::RobotConfig config = quadruped_config();
  config.tau_max.setConstant(torque);
  config.q_lower = (config.q_standing.array() - room).max(config.q_lower.array());
  config.q_upper = (config.q_standing.array() + room).min(config.q_upper.array());
  return quadruped(config);
}

/// Random numbers from a seed, and random gains and references made from them.
class RandomReference {
 public:
  explicit RandomReference(int seed) : generator_(static_cast<unsigned>(seed)) {}

  double number(double size) { return size * uniform_(generator_); }
  bool chance(double p) { return 0.5 * (uniform_(generator_) + 1.0) < p; }
  surefoot::Vector3 vector(double size) { return {number(size), number(size), number(size)}; }

  /// Return random gains; each optional task has weight in half of the draws.
  surefoot::Gains gains() {
    surefoot::Gains g;
    if (chance(0.5)) g.weight_momentum = 0.1 + std::abs(number(0.3));
    if (chance(0.5)) g.weight_posture = std::abs(number(0.02));
    g.hold_down = 0.08 + std::abs(number(0.1));
    g.force_max_contact = 1.0;
    return g;
  }

  /// Return a reference with random contacts, and with accelerations up to more than the robot can
  /// reach.
  surefoot::Reference reference(const surefoot::Robot& robot, surefoot::RobotState& state) {
    using namespace surefoot;
    Reference r = reference_at(robot, state);
    r.body_point = chance(0.5) ? BodyPoint::kBase : BodyPoint::kCenterOfMass;
    const double size = chance(0.3) ? 25.0 : 4.0;
    r.a_com = r.a_base = vector(size);
    r.alpha_world_base = vector(4.0 * size);
    r.L_com = vector(0.1);
    r.use_forces = chance(0.2);
    if (chance(0.3)) r.ground_normal = Vector3(number(0.2), number(0.2), 1.0).normalized();
    for (int leg = 0; leg < kLegs; ++leg) {
      FootReference& foot = r.feet[leg];
      foot.stance = !chance(0.15);
      foot.load = chance(0.2) ? std::abs(number(1.0)) : 1.0;
      foot.p_world += vector(0.005);
      foot.a_world = foot.stance ? Vector3::Zero() : vector(10.0);
      foot.f_world = Vector3(0.0, 0.0, 30.0) + vector(20.0);
      state.contact[leg] = chance(0.2) ? std::abs(number(1.0)) : 1.0;
    }
    if (chance(0.3)) state.f_external = vector(60.0);
    return r;
  }

 private:
  std::mt19937 generator_;
  std::uniform_real_distribution<double> uniform_{-1.0, 1.0};
};
