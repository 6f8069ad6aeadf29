// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <limits>
#include <memory>

#include "surefoot/estimator_report.hpp"
#include "surefoot/fallback_level.hpp"
#include "surefoot/planner.hpp"
#include "surefoot/qp_problem.hpp"
#include "surefoot/robot.hpp"
#include "surefoot/task.hpp"
#include "surefoot/types.hpp"

namespace surefoot {

/// Options of a Controller: fixed at construction, unlike gains.
struct ControllerOptions {
  /// [N.m.s/rad] Kd of every command, joint-side, with dq = 0; 0 .. 50. 0 is pure torque mode.
  /// Robots whose knees vibrate in pure torque mode may need a value above 0.
  double motor_damping = 0.0;
  /// [s] Time from a measurement to the moment when the command computed from it acts, 0 .. 0.05;
  /// identify_delay() in Python measures this time. The controller predicts the state over this
  /// time from the commands already sent. Prediction amplifies sensor noise, so leave the option at
  /// 0 if the real delay is at most a few ticks. In simulation no robot stood with a delay above
  /// 0.03 s.
  ///
  /// At 0 nothing is predicted for a standing robot. For a stepping robot (Reference::stepping) two
  /// periods are: swing feet are too fast to neglect them. The estimator then assumes that commands
  /// and samples each take one period over the SDK's link. So it compares the sample of tick k,
  /// measured at tick k - 1, with the command of tick k - 3, which acted from tick k - 2 to tick k
  /// - 1.
  double delay = 0.0;
  QpForm form = QpForm::kAuto;  ///< form of the whole-body QP
  /// [W] Largest power of a command, sum |tau dq| with the motors' damping included, at the joint
  /// velocities for which the command is computed. Must be > 0; infinity switches the limit off.
  ///
  /// Above the limit, the torques are scaled towards those that hold the robot against gravity, of
  /// swing legs first. If the holding torques alone exceed the limit, the command is not scaled,
  /// because a robot with too little torque falls, and its motors then take even more power.
  /// Finally, the torques of runaway legs are limited: the power of a leg may rise by at most a
  /// quarter of the limit within the next 15 ms, extrapolated from the acceleration of its joints.
  /// With periods of 10 ms and more, runaway legs are not detected.
  ///
  /// Set this limit below that of Safety::power_protect(), for example at 0.9 of it, but not far
  /// below the power that the motions take. A robot that lacks power for long falls.
  double power_limit = std::numeric_limits<double>::infinity();

  /// Throw surefoot::Error if an option is out of range; the message names it.
  void validate() const;
};

/// Controller that moves the robot as a Planner plans: LowState in, LowCmd out.
///
/// A tick estimates the state, calls the planner for the Reference and solves the whole-body QP.
/// Commands are in torque mode: motors 0 .. 11 have mode 0x0A, q = PosStopF, dq = VelStopF,
/// Kp = Kd = 0 and the torques of the QP.
///
/// If the solve fails or the reference is invalid, the tick tries the fallback levels in order, see
/// FallbackLevel. If the sample is unusable or the robot has fallen, the last command is repeated.
/// If the estimate diverges, or after a gap of more than 100 ms, the motors damp at once. Commands
/// have Kd > 0 only with ControllerOptions::motor_damping, for a lost leg, and at the levels
/// kGravity and kDamping. At most 10 ms may pass without a solved command; then damping is latched
/// until reset(): dq = 0, Kd > 0, tau = 0. All times are measured by LowState::tick.
///
/// Assumes twelve joints on a free base, spherical feet, and one ground plane under all stance
/// feet. Not thread-safe.
class Controller {
 public:
  /// Create a controller with RobotConfig::gains and default options. `planner` is the planner of
  /// this controller alone; reset() resets it too. Throws surefoot::Error if `planner` is null, if
  /// the robot does not have twelve joints on a free base, or if a gain or an option is invalid.
  Controller(const Robot& robot, std::shared_ptr<Planner> planner);
  /// The same with other gains than RobotConfig::gains.
  Controller(const Robot& robot, std::shared_ptr<Planner> planner, const Gains& gains,
             const ControllerOptions& options = {});
  virtual ~Controller();
  /// Take over the content of another Controller, which may only be destroyed afterwards.
  Controller(Controller&&) noexcept;

  /// Compute one tick. Never throws, allocates, locks or logs. Real-time: yes, if the planner and
  /// the custom tasks are.
  /// @param low_state newest sample; its tick must advance
  /// @return the command to send; status() and fallback_level() report its quality
  const LowCmd& update(const LowState& low_state) noexcept;

  /// Give up a leg, 0 .. 3, until reset(): its foot carries no load from now on, its motors damp,
  /// and the planner receives it as PlannerInput::lost_leg. The call is ignored if a leg is already
  /// lost or `leg` is not 0 .. 3. Real-time: yes.
  void declare_leg_lost(int leg) noexcept;
  int lost_leg() const noexcept;  ///< leg that was given up, 0 .. 3, or -1

  /// Set the share of its torque limit that each motor may use, see
  /// WholeBodyController::set_torque_share(). Real-time: yes.
  void set_torque_share(const Vector12& share) noexcept;

  /// Add a custom task, in force from the next tick on. Throws surefoot::Error if `task` is null or
  /// its rows() is not 1 .. 1000. Real-time: no.
  void add_task(std::shared_ptr<Task> task);

  /// Status of the last tick: kOk, kSaturated, or the reason why the QP gave no command; kDamping
  /// while damping is latched.
  Status status() const noexcept;
  /// Fallback level of the last command; kDamping before the first tick.
  FallbackLevel fallback_level() const noexcept;
  /// Return the number of ticks that ended at a fallback level, since construction. Real-time: yes.
  std::uint64_t fallback_count(FallbackLevel fallback_level) const noexcept;
  /// Status of the last tick without a usable command; kept while damping is latched, kOk after
  /// reset().
  Status fault() const noexcept;

  /// Estimated state. After a tick that reached the QP, state().friction is the share that the QP
  /// could use: in general at most 0.7 while the capture point is more than 6 cm inside the support
  /// edges, and less while a foot slips; all of them of the learnt friction. After any other tick,
  /// state().friction contains only the learnt friction and the reduction for slipping feet.
  const RobotState& state() const noexcept;
  EstimatorReport estimator_report() const noexcept;  ///< see StateEstimator::report()
  /// Reference that the last tick with a good estimate used: that of the planner, or the last valid
  /// one if the status is kBadReference. Default before the first valid reference.
  const Reference& reference() const noexcept;
  const Solution& solution() const noexcept;  ///< QP solution of the last good tick
  const QpProblem& qp() const noexcept;       ///< see WholeBodyController::qp()
  bool has_foot_force_est() const noexcept;   ///< see StateEstimator::has_foot_force_est()
  Eigen::Vector4d normal_forces_from_torques()
      const noexcept;  ///< [N] see StateEstimator, same name
  /// [W] Power sum |tau dq| of the last command that was computed from a sample, with the motors'
  /// damping included. dq are the joint velocities for which the command was computed: measured, or
  /// predicted over ControllerOptions::delay. A lost leg counts with its torques before they were
  /// set to zero. The power exceeds ControllerOptions::power_limit only if the torques that hold
  /// the robot exceed that limit.
  double command_power() const noexcept;
  /// Scale s, 0 .. 1, by which ControllerOptions::power_limit reduced the torques of the last good
  /// tick: tau = tau_hold + s (tau_QP - tau_hold) for the legs that carry. Below 1, status() is
  /// kSaturated, and solution() still has the torques of the QP. If only swing legs or a runaway
  /// leg were limited, status() is kSaturated and s is 1.
  double power_scale() const noexcept;
  const Gains& gains() const noexcept;         ///< gains last set, see set_gains()
  const Gains& active_gains() const noexcept;  ///< gains of the last tick, which approach gains()

  /// Set the gains, between ticks. While the controller is active, active_gains() approach the new
  /// gains within 0.1 s, counted over good ticks only, so that torques do not jump. Before the
  /// first good sample and while damping is latched, active_gains() change at once. Throws
  /// surefoot::Error and changes nothing if a gain is invalid. Real-time: no.
  void set_gains(const Gains& gains);
  /// Leave damping, clear the lost leg and the reference, reset the planner, and start again with
  /// the next good sample. Real-time: yes, if the planner is.
  void reset() noexcept;

 private:
  struct Impl;
  friend struct ControllerAccess;  // defined in the library
  std::unique_ptr<Impl> impl_;
};

}  // namespace surefoot
