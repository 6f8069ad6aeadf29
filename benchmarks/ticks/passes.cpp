// SPDX-License-Identifier: BSD-3-Clause
#include "passes.hpp"

#include <algorithm>
#include <surefoot/whole_body_controller.hpp>

#include "heap.hpp"

namespace bench {

namespace {

using namespace surefoot;

constexpr long kMostOfAStage = 100000;

// One pass to warm up, then those that count, with what they cost the heap and the pager.
template <typename Pass>
void run_passes(const Plan& plan, Series& series, Pass&& pass) {
  pass();
  series.samples.clear();
  const long allocations = heap_allocations(), faults = page_faults();
  for (long k = 0; k < plan.passes; ++k) pass();
  series.allocations = heap_allocations() - allocations;
  series.page_faults = page_faults() - faults;
}

// Touched once, so that its pages are there.
Series make_series(const char* name, const Plan& plan) {
  Series series(name, static_cast<std::size_t>(plan.passes) * plan.reports.size());
  series.samples.resize(series.samples.capacity());
  series.samples.clear();
  return series;
}

template <typename Controller>
void note(const Controller& controller, Status status, Sample& sample) {
  sample.iterations = static_cast<std::uint16_t>(controller.solution().iterations);
  sample.failed = is_usable(status) ? 0 : 1;
}

}  // namespace

Series time_ticks(const Plan& plan) {
  Series series = make_series("tick", plan);
  StandController controller(plan.robot, plan.gains, StandOptions{0.0, 0.0, plan.form});
  run_passes(plan, series, [&] {
    controller.reset();
    for (const LowState& report : plan.reports) {
      Sample sample = timed([&] { controller.update(report); });
      note(controller, controller.status(), sample);
      series.samples.push_back(sample);
    }
  });
  return series;
}

Series time_state_to_torque(const Plan& plan) {
  StandController stand(plan.robot, plan.gains, StandOptions{0.0, 0.0, plan.form});
  std::vector<RobotState> states;
  std::vector<Reference> references;
  for (const LowState& report : plan.reports) {
    stand.update(report);
    states.push_back(stand.state());
    references.push_back(stand.reference());
  }
  Series series = make_series("state_to_torque", plan);
  WholeBodyController controller(plan.robot, plan.gains, WholeBodyOptions{plan.form});
  run_passes(plan, series, [&] {
    controller.reset();
    for (std::size_t k = 0; k < states.size(); ++k) {
      Sample sample = timed([&] { controller.update(states[k], references[k]); });
      note(controller, controller.solution().status, sample);
      series.samples.push_back(sample);
    }
  });
  return series;
}

std::vector<Series> time_stages(const Plan& plan) {
  // Nine series of a million would be long to read and tell no more.
  const long passes =
      std::min(plan.passes, std::max(1L, kMostOfAStage / static_cast<long>(plan.reports.size())));
  std::vector<Series> stages;
  for (std::size_t k = 0; k < kStages; ++k) {
    stages.push_back(make_series(to_string(static_cast<Stage>(k)), plan));
    stages.back().wants_cpu = false;
  }
  StandController controller(plan.robot, plan.gains, StandOptions{0.0, 0.0, plan.form});
  StageClock clock;
  for (long pass = 0; pass <= passes; ++pass) {
    controller.reset();
    for (Series& stage : stages) {
      if (pass == 1) stage.samples.clear();
    }
    for (const LowState& report : plan.reports) {
      clock.start();
      controller.update(report);
      clock.stop();
      for (std::size_t k = 0; k < kStages; ++k) {
        Sample sample;
        sample.wall = static_cast<float>(1e-3 * clock.time(static_cast<Stage>(k)));
        stages[k].samples.push_back(sample);
      }
    }
  }
  return stages;
}

Series time_null(const Plan& plan, double length) {
  const auto spin = [](long rounds) {
    for (volatile long k = 0; k < rounds; k = k + 1) {
    }
  };
  constexpr long kTrial = 1000000;
  const long rounds = static_cast<long>(kTrial * length / timed([&] { spin(kTrial); }).wall);
  Series series = make_series("null", plan);
  run_passes(plan, series, [&] {
    for (std::size_t k = 0; k < plan.reports.size(); ++k) {
      series.samples.push_back(timed([&] { spin(rounds); }));
    }
  });
  return series;
}

}  // namespace bench
