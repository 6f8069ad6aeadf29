// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/stand_controller.hpp"
#include "surefoot/walk_velocity.hpp"

namespace surefoot {

/// Options of a WalkController: fixed at construction, unlike gains.
struct WalkOptions {
  ControllerOptions tick = {};  ///< options of the tick
  /// [s] Age above which a commanded velocity becomes 0, 0.01 .. 60. So the robot stops if the
  /// calling program ends.
  double velocity_timeout = 0.5;

  /// Throw surefoot::Error if an option is out of range; the message names it.
  void validate() const;
};

/// A StandController that also walks: LowState and a velocity in, LowCmd out.
///
/// At velocity 0 it stands; with Gait::kTrot it trots on the spot. At another velocity it trots, or
/// with Gait::kWalk walks with three feet down. Footholds follow the measured velocity, so steps
/// brake pushes. Height, roll and pitch of set_body_reference() apply while it steps, relative to
/// the standing pose. When the velocity is 0 again, it steps until it can stand in the nominal
/// stance. With a lost leg it only stands.
class WalkController : public StandController {
 public:
  /// Create a controller with RobotConfig::gains and default options. Throws surefoot::Error if the
  /// robot does not have twelve joints on a free base, if it cannot walk (see can_walk()), or if a
  /// gain or an option is invalid.
  explicit WalkController(const Robot& robot);
  /// The same with other gains than RobotConfig::gains.
  WalkController(const Robot& robot, const Gains& gains, const WalkOptions& options = {});
  ~WalkController() override;
  /// Take over the content of another WalkController, which may only be destroyed afterwards.
  WalkController(WalkController&&) noexcept;

  /// Command a velocity; call it more often than WalkOptions::velocity_timeout. The velocity is
  /// clamped to the gains walk_speed_forward, walk_speed_backward, walk_speed_sideways and
  /// walk_turn_speed, in the gait kWalk to walk_gait_speed and walk_gait_turn_speed. Then all three
  /// are reduced to what can be combined, and to what ControllerOptions::power_limit carries. A
  /// velocity with a NaN or an infinity is ignored. velocity_limit() has the last limit that acted,
  /// or kNotFinite. Real-time: yes.
  void set_velocity(const WalkVelocity& velocity) noexcept;
  /// Return the commanded velocity: clamped, and 0 after the timeout. Real-time: yes.
  WalkVelocity commanded_velocity() const noexcept;
  /// Return the planned velocity, which approaches commanded_velocity(). Real-time: yes.
  WalkVelocity reference_velocity() const noexcept;
  /// Return the limit that reduced the commanded velocity, in the present gait. Real-time: yes.
  WalkLimit velocity_limit() const noexcept;

  /// Set the gait from the next tick on. Real-time: yes.
  void set_gait(Gait gait) noexcept;
  Gait gait() const noexcept;     ///< gait last set; initially kAuto. Real-time: yes.
  bool walking() const noexcept;  ///< whether the last tick planned steps. Real-time: yes.
  /// Whether the last velocity is older than WalkOptions::velocity_timeout, or none was set since
  /// reset(). Real-time: yes.
  bool velocity_expired() const noexcept;
  /// Whether the motors can carry the robot in the standing pose on two diagonal feet, with at most
  /// 0.8 of their torque limits. If not, the controller only stands; only a Supervisor has such a
  /// controller, because the public constructors throw. Real-time: yes.
  bool can_walk() const noexcept;
  /// Footholds FR FL RR RL, world frame of state() [m]: where each foot lands or has landed.
  /// Real-time: yes.
  FeetMatrix footholds() const noexcept;
  /// Planned loads FR FL RR RL, 0 .. 1; 0: the foot swings. Real-time: yes.
  Eigen::Vector4d planned_loads() const noexcept;

 protected:
  /// Selects the constructor without the check that the robot can walk.
  struct Unchecked {};
  /// Create a controller without the check that the robot can walk.
  WalkController(Unchecked, const Robot& robot, const Gains& gains, const WalkOptions& options);
};

}  // namespace surefoot
