// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/robot.hpp"

/// A quadruped for the tests, built without a file: 12 kg, legs of 0.2 + 0.2 m.
surefoot::RobotConfig quadruped_config();
surefoot::Robot quadruped(const surefoot::RobotConfig& config = quadruped_config());

/// The same robot with one more joint, an arm on its trunk: 5 N.m, 4 rad/s, -1 .. 1 rad.
surefoot::Robot quadruped_with_arm();
