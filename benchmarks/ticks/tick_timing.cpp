// SPDX-License-Identifier: BSD-3-Clause
#include "tick_timing.hpp"

#include <algorithm>
#include <surefoot/whole_body_controller.hpp>

#include "memory_counters.hpp"

namespace bench {

namespace {

using namespace surefoot;

// Largest number of timings per stage; one whole pass is timed even if it has more LowStates.
constexpr long kMaxStageTimings = 100000;
constexpr std::size_t kPacedTicks = 500;  // number of paced ticks: one second at 500 Hz

// Count the heap allocations and page faults of a call.
template <typename Call>
void count_memory(long& allocations, long& faults, Call&& call) {
  const long allocations_before = heap_allocations(), faults_before = page_faults();
  call();
  allocations = heap_allocations() - allocations_before;
  faults = page_faults() - faults_before;
}

// Run one untimed pass to warm up, with its own counts, and then the timed passes.
template <typename Pass>
void run_passes(const ReplayPlan& plan, Series& series, Pass&& pass) {
  count_memory(series.first_allocations, series.first_page_faults, pass);
  series.timings.clear();
  series.walking = 0;
  count_memory(series.allocations, series.page_faults, [&] {
    for (long k = 0; k < plan.passes; ++k) pass();
  });
}

timespec add_microseconds(timespec time, long us) {
  time.tv_nsec += 1000 * us;
  time.tv_sec += time.tv_nsec / 1000000000;
  time.tv_nsec %= 1000000000;
  return time;
}

// Every page of the memory is touched, so that it is mapped before timing.
Series make_series(const char* name, std::size_t capacity) {
  Series series(name, capacity);
  series.timings.resize(series.timings.capacity());
  series.timings.clear();
  return series;
}

Series make_series(const char* name, const ReplayPlan& plan) {
  return make_series(name, static_cast<std::size_t>(plan.passes) * plan.low_states.size());
}

// Time one tick and add it to a series.
void time_tick(ReplayController& controller, std::size_t tick, Series& series) {
  CallTiming timing = time_call([&] { controller.update(tick); });
  timing.iterations = static_cast<std::uint16_t>(controller.get().solution().iterations);
  timing.failed = controller.solved() ? 0 : 1;
  series.timings.push_back(timing);
  series.walking += controller.walking() ? 1 : 0;
}

}  // namespace

Series time_ticks(const ReplayPlan& plan) {
  Series series = make_series("tick", plan);
  ReplayController controller(plan);
  run_passes(plan, series, [&] {
    controller.start();
    for (std::size_t k = 0; k < plan.low_states.size(); ++k) {
      controller.request(k);
      time_tick(controller, k, series);
    }
  });
  return series;
}

Series time_paced_ticks(const ReplayPlan& plan) {
  Series series = make_series("paced", kPacedTicks);
  ReplayController controller(plan);
  timespec due{};
  clock_gettime(CLOCK_MONOTONIC, &due);
  count_memory(series.allocations, series.page_faults, [&] {
    for (std::size_t k = 0; k < std::min(kPacedTicks, plan.low_states.size()); ++k) {
      due = add_microseconds(due, plan.period);
      clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &due, nullptr);
      controller.request(k);
      time_tick(controller, k, series);
    }
  });
  return series;
}

Series time_state_to_torque(const ReplayPlan& plan) {
  ReplayController whole(plan);
  std::vector<RobotState> states;
  std::vector<Reference> references;
  for (std::size_t k = 0; k < plan.low_states.size(); ++k) {
    whole.request(k);
    whole.update(k);
    states.push_back(whole.get().state());
    references.push_back(whole.get().reference());
  }
  Series series = make_series("state_to_torque", plan);
  WholeBodyController controller(plan.robot, plan.gains, WholeBodyOptions{plan.form});
  run_passes(plan, series, [&] {
    controller.reset();
    for (std::size_t k = 0; k < states.size(); ++k) {
      CallTiming timing = time_call([&] { controller.update(states[k], references[k]); });
      timing.iterations = static_cast<std::uint16_t>(controller.solution().iterations);
      timing.failed = is_usable(controller.solution().status) ? 0 : 1;
      series.timings.push_back(timing);
      series.walking += references[k].stepping ? 1 : 0;
    }
  });
  return series;
}

std::vector<Series> time_stages(const ReplayPlan& plan) {
  // Limit the number of passes: every stage has its own series, and more timings add no
  // information.
  const long passes = std::min(
      plan.passes, std::max(1L, kMaxStageTimings / static_cast<long>(plan.low_states.size())));
  std::vector<Series> stages;
  for (std::size_t k = 0; k < kStages; ++k) {
    stages.push_back(make_series(to_string(static_cast<Stage>(k)), plan));
    stages.back().has_cpu_time = false;
  }
  ReplayController controller(plan);
  StageClock clock;
  // Pass 0 warms up; its timings are discarded at the start of pass 1.
  for (long pass = 0; pass <= passes; ++pass) {
    controller.start();
    for (Series& stage : stages) {
      if (pass == 1) stage.timings.clear();
    }
    for (std::size_t tick = 0; tick < plan.low_states.size(); ++tick) {
      controller.request(tick);
      clock.start();
      controller.update(tick);
      clock.stop();
      for (std::size_t k = 0; k < kStages; ++k) {
        CallTiming timing;
        timing.wall = static_cast<float>(1e-3 * clock.time(static_cast<Stage>(k)));
        stages[k].timings.push_back(timing);
      }
    }
  }
  return stages;
}

Series time_null(const ReplayPlan& plan, double length) {
  const auto spin = [](long rounds) {
    for (volatile long k = 0; k < rounds; k = k + 1) {
    }
  };
  constexpr long kCalibrationRounds = 1000000;
  const long rounds = static_cast<long>(kCalibrationRounds * length /
                                        time_call([&] { spin(kCalibrationRounds); }).wall);
  Series series = make_series("null", plan);
  run_passes(plan, series, [&] {
    for (std::size_t k = 0; k < plan.low_states.size(); ++k) {
      series.timings.push_back(time_call([&] { spin(rounds); }));
    }
  });
  return series;
}

}  // namespace bench
