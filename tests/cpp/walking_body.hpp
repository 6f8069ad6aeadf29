// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "gait/body_trajectory.hpp"
#include "quadruped.hpp"

namespace surefoot {

/// A body trajectory, and a measured body that follows it exactly.
struct WalkingBody {
  static constexpr double kDt = 0.002;  // [s]

  Gains gains;
  GaitSize size{quadruped()};
  BodyTrajectory body{size};
  HorizontalMotion measured{Eigen::Vector2d(1.0, -2.0), Eigen::Vector2d::Zero(), 0.4};
  Reference reference;

  WalkingBody() { body.start(measured, size.height); }
  void tick(const WalkVelocity& command) {
    body.update(gains, command, measured, 1.0, kDt);
    measured.v_com = body.v_world();
    measured.p_com += kDt * measured.v_com;
    measured.yaw = std::remainder(body.yaw(), 2.0 * M_PI);
  }
  void walk(const WalkVelocity& command, double seconds) {
    for (int k = 0; k < seconds / kDt - 0.5; ++k) tick(command);
  }
};

}  // namespace surefoot
