// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <limits>
#include <memory>

#include "surefoot/body_reference.hpp"
#include "surefoot/estimator_report.hpp"
#include "surefoot/fallback_level.hpp"
#include "surefoot/qp_problem.hpp"
#include "surefoot/robot.hpp"
#include "surefoot/task.hpp"
#include "surefoot/types.hpp"

namespace surefoot {

/// What is set once, as opposed to tuned.
struct StandOptions {
  /// [N.m.s/rad] Motor-side damping added to every command, with dq = 0. 0 is pure torque mode;
  /// hardware whose knees buzz under pure torque may need some.
  double motor_damping = 0.0;
  /// [s] from a measurement to the action of the command made from it; the state is predicted over
  /// it with the commands already sent. Up to 0.05; beyond 0.03 no robot here stood in simulation.
  /// Prediction passes on more of the sensors' noise: leave it at 0 for delays up to a few ticks.
  /// At 0 nothing is predicted, and what a report feels is held against the command of two periods
  /// before it: one that a report and one that a command is on its way over the SDK's link.
  double delay = 0.0;
  QpForm form = QpForm::kAuto;
  /// [W] Most that a command may take by the joint velocities reported, sum |tau dq|, > 0; infinite
  /// is off. Beyond it torques are scaled towards those that hold the robot against gravity; where
  /// these alone take more, the command goes unscaled, for letting go would make the robot fall and
  /// take more yet. Set it below what Safety::power_protect() allows (0.9 of it, say), and not far
  /// below what the motions take: a controller held back for long lets the robot fall. Last,
  /// a leg that gathers speed along its own torques, for its foot slides off or has lost the
  /// ground, gets no more of them than its power rises by a quarter of the limit within
  /// 15 ms; with periods of 10 ms and more none is seen.
  double power_limit = std::numeric_limits<double>::infinity();

  /// Throw surefoot::Error naming what is out of range.
  void validate() const;
};

/// Holds the body where and as it stands, or where a BodyReference asks it to be: LowState in,
/// LowCmd out. The whole tick.
///
/// The first good report latches the pose, relative to the feet. Commands are torque mode: motors
/// 0 .. 11 in mode 0x0A with q = PosStopF, dq = VelStopF, Kp = Kd = 0 and tau from the whole-body
/// program. Where a solve fails, the tick goes down a ladder (Rung): solve once more from nothing;
/// share what changed of the wanted wrench among the feet without a program; the last forces
/// through today's Jacobians; hold against gravity (here alone Kd > 0). Where a report is bad, the
/// command that left last is repeated. What is not solved leaves for at most 10 ms on end; then the
/// motors damp (dq = 0, Kd > 0, tau = 0) until reset(). Time comes from LowState::tick.
class StandController {
 public:
  /// Throws surefoot::Error when the robot (twelve joints on a free base), a gain or an option is
  /// invalid.
  explicit StandController(const Robot& robot);
  StandController(const Robot& robot, const Gains& gains, const StandOptions& options = {});
  ~StandController();
  StandController(StandController&&) noexcept;

  /// Compute one tick; never throws, allocates, locks or logs. Real-time: yes.
  /// @return the command; status() says what it is worth
  const LowCmd& update(const LowState& low_state) noexcept;

  /// Ask for another pose of the body; it goes there at limited speed, and stops where the robot
  /// could not stand. Numbers that are not finite change nothing but reach(). Real-time: yes.
  void set_body_reference(const BodyReference& target) noexcept;
  BodyReference body_reference() const noexcept;  ///< where it is on the way
  ReachStatus reach() const noexcept;             ///< what keeps it from getting there

  /// Give a leg up, 0 .. 3, until reset(): its foot bears nothing from now on, and the body goes
  /// over the other three. One leg at most; another's number, or none's, changes nothing.
  /// Real-time: yes.
  void give_up_leg(int leg) noexcept;
  int lost_leg() const noexcept;  ///< that was given up, or -1
  /// [m] how far the capture point is inside the triangle of the other three feet; negative
  /// outside; infinite where another leg is lost, for two feet have no inside; NaN for none of 0 ..
  /// 3 and before the first tick. Of the last good tick. Real-time: yes.
  double capture_margin_without(int leg) const noexcept;

  /// See WholeBodyController::set_torque_share(). Real-time: yes.
  void set_torque_share(const Vector12& share) noexcept;

  /// Add a task of your own; not in the tick. Throws surefoot::Error.
  void add_task(std::shared_ptr<Task> task);

  /// kOk, kSaturated, or why this tick's command is not solved; kDamping while latched.
  Status status() const noexcept;
  /// Where this tick's command came from; kDamping before the first.
  FallbackLevel fallback_level() const noexcept;
  /// Ticks that came to this rung, since construction. Real-time: yes.
  std::uint64_t fallback_count(FallbackLevel fallback_level) const noexcept;
  /// What was wrong when the last tick was not kOk; stays after the damping has latched.
  Status fault() const noexcept;

  const RobotState& state() const noexcept;  ///< estimated; friction: what may be used of it
  EstimatorReport estimator_report() const noexcept;  ///< see StateEstimator::report()
  const Reference& reference() const noexcept;        ///< of the last good tick
  const Solution& solution() const noexcept;          ///< of the last good tick
  const QpProblem& qp() const noexcept;               ///< see WholeBodyController::qp()
  bool has_foot_force_est() const noexcept;           ///< does footForceEst carry anything?
  Eigen::Vector4d normal_forces_from_torques()
      const noexcept;  ///< [N] normal force per foot from torques
  /// [W] sum |tau dq| that the last command made from a report takes, by the joint velocities it
  /// was made for. Above the option power_limit only where holding still alone is above it.
  double command_power() const noexcept;
  /// How much of the torques' way from holding still was left to the last good tick, 0 .. 1; below
  /// 1 (power_limit) status() is kSaturated, and solution() is what was planned. It is kSaturated
  /// at 1, too, where a leg that its torques fling got less of them.
  double power_scale() const noexcept;
  const Gains& gains() const noexcept;         ///< asked for; see set_gains()
  const Gains& active_gains() const noexcept;  ///< on their way to those

  /// Change gains between ticks; throws surefoot::Error and changes nothing if one is invalid.
  /// Those of a controller that is at work move there in 0.1 s of good ticks, for torques not to
  /// jump; where nothing is computed, before the first report and while damping, at once.
  void set_gains(const Gains& gains);
  /// Leave damping, forget the body reference and a lost leg, latch the pose anew with the next
  /// report. Real-time: yes.
  void reset() noexcept;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace surefoot
