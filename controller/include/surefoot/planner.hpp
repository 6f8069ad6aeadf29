// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/gains.hpp"
#include "surefoot/types.hpp"

namespace surefoot {

class Dynamics;

/// What a planner sees of a tick: the estimated state, and kinematics computed from it. All
/// quantities are in the world frame of `state`.
struct PlannerInput {
  const RobotState& state;   ///< estimated state, see StateEstimator
  const Gains& gains;        ///< gains of this tick
  const Dynamics& dynamics;  ///< kinematics and dynamics at `state`; opaque outside the library
  double dt;                 ///< [s] time since the last good tick, at most 0.01
  /// [s] Time from `state` until the command of this tick acts, see ControllerOptions::delay. The
  /// QP of a stepping robot uses the state predicted for that time, so its reference is planned for
  /// it too.
  double delay;
  double mass;           ///< [kg] mass of the robot
  Vector3 p_com;         ///< [m] centre of mass
  Vector3 v_com;         ///< [m/s] velocity of the centre of mass
  Matrix3 R_world_base;  ///< orientation of the base in the world
  Vector3 w_world_base;  ///< [rad/s] angular velocity of the base, world axes
  FeetMatrix p_feet;     ///< [m] contact points of rigid soles, FR FL RR RL
  FeetMatrix v_feet;     ///< [m/s] velocities of the contact points, FR FL RR RL
  /// [m] Depth by which each sole has yielded along the normal of the ground, FR FL RR RL: the
  /// unloaded ground is this far above p_feet.
  Eigen::Vector4d sole_sink;
  /// Lost leg, 0 .. 3, or -1. The controller plans no load for its foot, whatever the
  /// planner writes.
  int lost_leg;
};

/// Base class of planners: a planner writes the Reference of each tick, see Controller and
/// examples/custom_planner.cpp.
class Planner {
 public:
  virtual ~Planner() = default;
  /// Write the reference of this tick. Fields that are not written keep the values of the last
  /// valid reference. Before the first one, the reference is a default Reference with the standing
  /// pose as posture; its elements can be written without allocation. Called in every tick
  /// with a good estimate of a robot that has not fallen. Real-time: required.
  /// @return false to end the tick with Status::kBadReference, else true. A number that is not
  /// finite also ends the tick with kBadReference. Then the tick tries the fallback levels with the
  /// last valid reference. Before the first valid reference, the motors damp.
  virtual bool plan(const PlannerInput& input, Reference& reference) noexcept = 0;
  /// Clear the planner's state: the next plan() is the first of a new start. Controller::reset()
  /// calls this function. Real-time: required.
  virtual void reset() noexcept = 0;
};

}  // namespace surefoot
