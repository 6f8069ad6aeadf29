// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "quadruped.hpp"
#include "surefoot/types.hpp"

/// Return a random moving state near the standing pose.
surefoot::RobotState random_state(const surefoot::Robot& robot, int seed, double speed = 0.3);

/// Return the standing pose at rest, with the contact points at height zero.
surefoot::RobotState standing_state(const surefoot::Robot& robot);

/// Return a reference that equals the state: feet and centre of mass stay where they are.
surefoot::Reference reference_at(const surefoot::Robot& robot, const surefoot::RobotState& state);

/// Return the sample of a robot at rest in the standing pose, with static torques.
surefoot::LowState resting_sample(const surefoot::Robot& robot, std::uint32_t tick);

/// Return whether all motors brake and do nothing else.
bool motors_brake(const surefoot::LowCmd& command);

// Results of Pinocchio's own functions, compiled once for all tests.
Eigen::VectorXd integrate(const surefoot::Robot& robot, const Eigen::VectorXd& q,
                          const Eigen::VectorXd& step);
Eigen::MatrixXd mass_matrix(const surefoot::Robot& robot, const Eigen::VectorXd& q);
Eigen::VectorXd inverse_dynamics(const surefoot::Robot& robot, const surefoot::RobotState& state,
                                 const Eigen::VectorXd& a);
Eigen::VectorXd armature(const surefoot::Robot& robot);
/// Return the contact points on level ground.
surefoot::FeetMatrix contact_points(const surefoot::Robot& robot, const Eigen::VectorXd& q);
surefoot::Vector3 center_of_mass(const surefoot::Robot& robot, const Eigen::VectorXd& q);
