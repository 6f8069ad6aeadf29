// SPDX-License-Identifier: BSD-3-Clause
#include "surefoot/stage_clock.hpp"

#include "clock.hpp"

namespace surefoot {

namespace {

thread_local StageClock* current = nullptr;

double nanoseconds() noexcept { return 1e9 * monotonic_time(); }

}  // namespace

const char* to_string(Stage stage) noexcept {
  constexpr const char* kNames[kStages] = {"estimate", "dynamics", "reference", "tasks", "condense",
                                           "program",  "solve",    "check",     "safety"};
  const auto k = static_cast<std::size_t>(stage);
  return k < kStages ? kNames[k] : "unknown";
}

StageClock::StageClock() noexcept { current = this; }

StageClock::~StageClock() {
  if (current == this) current = nullptr;
}

void StageClock::start() noexcept {
  times_.fill(0.0);
  stage_ = Stage::kSafety;
  since_ = nanoseconds();
}

void StageClock::stop() noexcept { enter(Stage::kSafety); }

Stage StageClock::enter(Stage stage) noexcept {
  const double now = nanoseconds();
  times_[static_cast<std::size_t>(stage_)] += now - since_;
  since_ = now;
  const Stage before = stage_;
  stage_ = stage;
  return before;
}

StageScope::StageScope(Stage stage) noexcept : clock_(current) {
  if (clock_ != nullptr) before_ = clock_->enter(stage);
}

StageScope::~StageScope() {
  if (clock_ != nullptr) clock_->enter(before_);
}

}  // namespace surefoot
