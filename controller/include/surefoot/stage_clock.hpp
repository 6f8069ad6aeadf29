// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>

namespace surefoot {

/// The parts of a tick, in the order of the data's way.
enum class Stage : std::size_t {
  kEstimate,   ///< LowState checked and turned into a RobotState, without the dynamics
  kDynamics,   ///< kinematics, mass matrix, bias, foot Jacobians and drifts
  kReference,  ///< the body reference on its way, the support frame
  kTasks,      ///< desired accelerations, limits, even forces
  kCondense,   ///< accelerations and torques as functions of the contact forces
  kProgram,    ///< the quadratic program written, its answer read
  kSolve,      ///< the solver
  kCheck,      ///< our own residuals of its answer
  kSafety,     ///< the command: limits, power, holding and damping; and what is nowhere else
  kCount
};
constexpr std::size_t kStages = static_cast<std::size_t>(Stage::kCount);
const char* to_string(Stage stage) noexcept;

/// Splits a tick's time among its stages, for the thread that made it current. A benchmark's: with
/// none current a stage costs a few nanoseconds. Real-time: yes.
class StageClock {
 public:
  /// Be the one that this thread's ticks report to; until destroyed.
  StageClock() noexcept;
  ~StageClock();
  StageClock(const StageClock&) = delete;
  StageClock& operator=(const StageClock&) = delete;

  void start() noexcept;  ///< forget what there is; time runs for kSafety
  void stop() noexcept;   ///< book the rest
  /// [ns] of a stage since start().
  double time(Stage stage) const noexcept { return times_[static_cast<std::size_t>(stage)]; }

 private:
  friend class StageScope;
  Stage enter(Stage stage) noexcept;
  std::array<double, kStages> times_{};
  Stage stage_ = Stage::kSafety;
  double stage_start_ = 0.0;  // [ns]
};

/// Books the time until it ends to a stage, and what comes after to the stage before.
class StageScope {
 public:
  explicit StageScope(Stage stage) noexcept;
  ~StageScope();
  StageScope(const StageScope&) = delete;
  StageScope& operator=(const StageScope&) = delete;

 private:
  StageClock* clock_;
  Stage previous_stage_ = Stage::kSafety;
};

}  // namespace surefoot
