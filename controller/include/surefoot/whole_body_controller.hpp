// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "surefoot/robot.hpp"
#include "surefoot/types.hpp"

namespace surefoot {

class Dynamics;

/// State and reference in, joint torques out: for people who bring their own estimator or planner.
///
/// Minimises, over the contact forces alone, the missed accelerations of the centre of mass and the
/// base's orientation and the distance from the most even forces; friction and normal force are
/// hard, and torques stay inside the motors' torque-speed curve. Rigid-body dynamics (armature
/// included) and contact accelerations hold exactly unless feet are asked to accelerate beyond what
/// their motors can give: then torques are clipped to the motors and the motion will differ.
class WholeBodyController {
 public:
  /// Throws surefoot::Error when the robot does not fit the condensed form or a gain is invalid.
  explicit WholeBodyController(const Robot& robot);
  WholeBodyController(const Robot& robot, const Gains& gains);
  ~WholeBodyController();
  WholeBodyController(WholeBodyController&&) noexcept;

  /// Compute one tick. Real-time: yes.
  ///
  /// @param state q and v of the robot's size, Pinocchio's order; contact 0 .. 1 per foot
  /// @param reference in the same world frame
  /// @return status kOk, or why the other fields are still those of the last good tick
  const Solution& update(const RobotState& state, const Reference& reference) noexcept;

  /// Make the reference that asks the robot to stay as it is: centre of mass, orientation and
  /// contact points where `state` has them, at rest. Throws surefoot::Error on a wrong size.
  Reference hold(const RobotState& state);

  /// update() on dynamics that are computed already (StandController's way in). Real-time: yes.
  /// @param dq_motor joint velocities in SDK motor order [rad/s]
  const Solution& solve(const Dynamics& dynamics, const Eigen::Vector4d& contact,
                        const Vector12& dq_motor, const Reference& reference) noexcept;

  const Solution& solution() const noexcept;
  const Gains& gains() const noexcept;

  /// Change gains between ticks; throws surefoot::Error and changes nothing if one is invalid.
  void set_gains(const Gains& gains);

  /// Forget the warm start.
  void reset() noexcept;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace surefoot
