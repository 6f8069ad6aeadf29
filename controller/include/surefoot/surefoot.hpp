// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Includes the whole public interface: #include <surefoot/surefoot.hpp>
#include "surefoot/arming.hpp"
#include "surefoot/body_reference.hpp"
#include "surefoot/controller.hpp"
#include "surefoot/error.hpp"
#include "surefoot/fault.hpp"
#include "surefoot/frames.hpp"
#include "surefoot/low_level.hpp"
#include "surefoot/planner.hpp"
#include "surefoot/robot.hpp"
#include "surefoot/runner.hpp"
#include "surefoot/safety.hpp"
#include "surefoot/stage_clock.hpp"
#include "surefoot/stand_controller.hpp"
#include "surefoot/state_estimator.hpp"
#include "surefoot/supervisor.hpp"
#include "surefoot/task.hpp"
#include "surefoot/udp_link.hpp"
#include "surefoot/walk_controller.hpp"
#include "surefoot/whole_body_controller.hpp"
#include "surefoot/wireless_remote.hpp"
