// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/controller.hpp"

namespace surefoot {

/// Access to the parts of a Controller, for derived controllers, the supervisor and tests.
/// Real-time: yes.
struct ControllerAccess {
  /// End the sensor check for good: the caller judges the sensors itself.
  static void end_sensor_check(Controller& controller) noexcept;
  /// Return kinematics and dynamics at the newest state estimate.
  static const Dynamics& dynamics(const Controller& controller) noexcept;
};

}  // namespace surefoot
