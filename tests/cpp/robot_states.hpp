// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "quadruped.hpp"
#include "surefoot/types.hpp"

/// A seeded state near the standing pose, moving.
surefoot::RobotState random_state(const surefoot::Robot& robot, int seed, double speed = 0.3);

/// At rest in the standing pose, contact points at height zero.
surefoot::RobotState standing_state(const surefoot::Robot& robot);

/// A reference that asks for what the state already has: feet and centre of mass where they are.
surefoot::Reference reference_at(const surefoot::Robot& robot, const surefoot::RobotState& state);

/// The report of a robot that stands still in the standing pose, torques from statics.
surefoot::LowState resting_sample(const surefoot::Robot& robot, std::uint32_t tick);

/// Do all motors brake by themselves, and do nothing else?
bool motors_brake(const surefoot::LowCmd& command);

// Pinocchio's own answers, compiled once for all tests.
Eigen::VectorXd integrate(const surefoot::Robot& robot, const Eigen::VectorXd& q,
                          const Eigen::VectorXd& step);
Eigen::MatrixXd mass_matrix(const surefoot::Robot& robot, const Eigen::VectorXd& q);
Eigen::VectorXd inverse_dynamics(const surefoot::Robot& robot, const surefoot::RobotState& state,
                                 const Eigen::VectorXd& a);
Eigen::VectorXd armature(const surefoot::Robot& robot);
/// Where the feet touch the ground, its normal upright.
surefoot::FeetMatrix contact_points(const surefoot::Robot& robot, const Eigen::VectorXd& q);
surefoot::Vector3 center_of_mass(const surefoot::Robot& robot, const Eigen::VectorXd& q);
