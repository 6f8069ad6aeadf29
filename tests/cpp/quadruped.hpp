// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <random>

#include "surefoot/robot.hpp"
#include "surefoot/types.hpp"

/// A quadruped of the tests' own, built without any file: 12 kg, legs of 0.2 + 0.2 m.
surefoot::RobotConfig quadruped_config();
surefoot::Robot quadruped();

/// A seeded state near the standing pose, moving.
surefoot::RobotState random_state(const surefoot::Robot& robot, int seed, double speed = 0.3);

/// A reference that asks for what the state already has: feet and centre of mass where they are.
surefoot::Reference reference_at(const surefoot::Robot& robot, const surefoot::RobotState& state);

/// The report of a robot that stands still in the standing pose, torques from statics.
surefoot::LowState resting_report(const surefoot::Robot& robot, std::uint32_t tick);

// Pinocchio's own answers, compiled once for all tests.
Eigen::VectorXd integrate(const surefoot::Robot& robot, const Eigen::VectorXd& q,
                          const Eigen::VectorXd& step);
Eigen::MatrixXd mass_matrix(const surefoot::Robot& robot, const Eigen::VectorXd& q);
Eigen::VectorXd inverse_dynamics(const surefoot::Robot& robot, const surefoot::RobotState& state,
                                 const Eigen::VectorXd& a);
Eigen::VectorXd armature(const surefoot::Robot& robot);
