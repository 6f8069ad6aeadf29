// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>

namespace surefoot {

/// Parts of a tick. The time of a nested stage counts only for the nested stage.
enum class Stage : std::size_t {
  kEstimate,    ///< check of the LowState, and state estimation without the dynamics
  kDynamics,    ///< kinematics, mass matrix, bias terms, foot Jacobians and drifts
  kReference,   ///< body reference and support frame
  kTasks,       ///< desired accelerations, joint limits, even forces
  kCondense,    ///< accelerations and torques as functions of the contact forces
  kQpAssembly,  ///< writing the QP and reading its solution
  kSolve,       ///< QP solver
  kCheck,       ///< residual check of the solver's result
  kSafety,      ///< power limit, command hold, and all work outside the other stages
  kCount        ///< number of stages, not a stage
};
constexpr std::size_t kStages = static_cast<std::size_t>(Stage::kCount);  ///< number of stages
/// Return the name of a stage, such as "solve". Real-time: yes.
const char* to_string(Stage stage) noexcept;

/// Measures the time that the ticks of one thread spend in each stage, for benchmarks. In a thread
/// without a clock, a StageScope costs a few nanoseconds. Real-time: yes.
class StageClock {
 public:
  /// Become the clock of the calling thread until the destructor runs.
  StageClock() noexcept;
  ~StageClock();
  StageClock(const StageClock&) = delete;
  StageClock& operator=(const StageClock&) = delete;

  void start() noexcept;  ///< set all times to zero and enter stage kSafety
  void stop() noexcept;   ///< add the time since the last change of stage to the present stage
  /// Return the time [ns] spent in a stage since start(). Real-time: yes.
  double time(Stage stage) const noexcept { return times_[static_cast<std::size_t>(stage)]; }

 private:
  friend class StageScope;
  Stage enter(Stage stage) noexcept;
  std::array<double, kStages> times_{};
  Stage stage_ = Stage::kSafety;
  double stage_start_ = 0.0;  // [ns]
};

/// Enters a stage of the thread's StageClock for its own lifetime. The destructor returns to the
/// previous stage.
class StageScope {
 public:
  /// Enter a stage; nothing happens in a thread without a clock. Real-time: yes.
  explicit StageScope(Stage stage) noexcept;
  ~StageScope();
  StageScope(const StageScope&) = delete;
  StageScope& operator=(const StageScope&) = delete;

 private:
  StageClock* clock_;
  Stage previous_stage_ = Stage::kSafety;
};

}  // namespace surefoot
