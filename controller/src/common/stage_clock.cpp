// SPDX-License-Identifier: BSD-3-Clause
#include "surefoot/stage_clock.hpp"

#include "common/clock.hpp"

namespace surefoot {

namespace {

thread_local StageClock* current_clock = nullptr;

double nanoseconds() noexcept { return 1e9 * monotonic_time(); }

}  // namespace

// The name of kQpAssembly is "program", for the QP as a quadratic program.
const char* to_string(Stage stage) noexcept {
  constexpr const char* kNames[kStages] = {"estimate", "dynamics", "reference", "tasks", "condense",
                                           "program",  "solve",    "check",     "safety"};
  const auto k = static_cast<std::size_t>(stage);
  return k < kStages ? kNames[k] : "unknown";
}

StageClock::StageClock() noexcept { current_clock = this; }

StageClock::~StageClock() {
  if (current_clock == this) current_clock = nullptr;
}

void StageClock::start() noexcept {
  times_.fill(0.0);
  stage_ = Stage::kSafety;
  stage_start_ = nanoseconds();
}

// A change of stage adds the time of the present stage. kSafety also counts all work outside the
// other stages.
void StageClock::stop() noexcept { enter(Stage::kSafety); }

Stage StageClock::enter(Stage stage) noexcept {
  const double now = nanoseconds();
  times_[static_cast<std::size_t>(stage_)] += now - stage_start_;
  stage_start_ = now;
  const Stage previous = stage_;
  stage_ = stage;
  return previous;
}

StageScope::StageScope(Stage stage) noexcept : clock_(current_clock) {
  if (clock_ != nullptr) previous_stage_ = clock_->enter(stage);
}

StageScope::~StageScope() {
  if (clock_ != nullptr) clock_->enter(previous_stage_);
}

}  // namespace surefoot
