// SPDX-License-Identifier: BSD-3-Clause
// Times the controller on recorded LowStates. `surefoot bench` runs it and reads its output.
//   surefoot_tick_bench NAME.robot LOW_STATES OUT [--form F] [--passes N] [--period-us P]
//                       [--references FILE] [--velocities FILE] [--gait G]
// The file LOW_STATES has packed LowStates. The file of --references has one BodyReference for each
// LowState, and the file of --velocities one WalkVelocity; the controller receives them before the
// LowState. With velocities it is a WalkController. The output file OUT begins with one line of
// JSON that describes every series. The bench::CallTiming records of all series follow in the same
// order.
#include <sys/mman.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iostream>
#include <surefoot/error.hpp>

#include "tick_timing.hpp"

namespace {

using namespace surefoot;

template <typename Record>
std::vector<Record> read_records(const char* path) {
  std::ifstream file(path, std::ios::binary);
  std::vector<Record> records;
  Record record;
  while (file.read(reinterpret_cast<char*>(&record), sizeof(record))) records.push_back(record);
  if (records.empty()) throw Error(std::string(path) + ": got an empty file, expected records");
  return records;
}

// Read a file with one record for each LowState.
template <typename Record>
std::vector<Record> read_requests(const std::string& option, const char* path, std::size_t count) {
  std::vector<Record> records = read_records<Record>(path);
  if (records.size() != count) {
    throw Error(option + ": got " + std::to_string(records.size()) +
                ", expected one per LowState: " + std::to_string(count));
  }
  return records;
}

QpForm to_form(const std::string& name) {
  for (const QpForm form : {QpForm::kAuto, QpForm::kCondensed, QpForm::kGeneral}) {
    if (name == to_string(form)) return form;
  }
  throw Error("--form: got '" + name + "', expected auto, condensed or general");
}

Gait to_gait(const std::string& name) {
  for (const Gait gait : {Gait::kAuto, Gait::kTrot, Gait::kWalk}) {
    if (name == to_string(gait)) return gait;
  }
  throw Error("--gait: got '" + name + "', expected auto, trot or walk");
}

bench::ReplayPlan read_plan(int argc, char** argv) {
  bench::ReplayPlan plan(Robot::load(argv[1]));
  plan.low_states = read_records<LowState>(argv[2]);
  plan.gains = plan.robot.config().gains;
  for (int k = 4; k + 1 < argc; k += 2) {
    if (!std::strcmp(argv[k], "--form")) plan.form = to_form(argv[k + 1]);
    if (!std::strcmp(argv[k], "--passes")) plan.passes = std::max(1L, std::atol(argv[k + 1]));
    if (!std::strcmp(argv[k], "--period-us")) plan.period = std::max(1L, std::atol(argv[k + 1]));
    if (!std::strcmp(argv[k], "--gait")) plan.gait = to_gait(argv[k + 1]);
    if (!std::strcmp(argv[k], "--references")) {
      plan.references = read_requests<BodyReference>(argv[k], argv[k + 1], plan.low_states.size());
    }
    if (!std::strcmp(argv[k], "--velocities")) {
      plan.velocities = read_requests<WalkVelocity>(argv[k], argv[k + 1], plan.low_states.size());
    }
  }
  return plan;
}

double median(const bench::Series& series) {
  std::vector<float> wall_times;
  for (const bench::CallTiming& timing : series.timings) wall_times.push_back(timing.wall);
  const auto middle = wall_times.begin() + static_cast<std::ptrdiff_t>(wall_times.size() / 2);
  std::nth_element(wall_times.begin(), middle, wall_times.end());
  return *middle;
}

void write_series(const char* path, const std::vector<bench::Series>& all, bool locked) {
  std::ofstream file(path, std::ios::binary);
  file << "{\"compiler\": \"" << SUREFOOT_COMPILER << "\", \"flags\": \"" << SUREFOOT_FLAGS
       << "\", \"memory_locked\": " << (locked ? "true" : "false") << ", \"series\": [";
  for (const bench::Series& s : all) {
    file << (&s == all.data() ? "" : ", ") << "{\"name\": \"" << s.name
         << "\", \"n\": " << s.timings.size() << ", \"walking\": " << s.walking
         << ", \"allocations\": " << s.allocations << ", \"page_faults\": " << s.page_faults
         << ", \"first_allocations\": " << s.first_allocations
         << ", \"first_page_faults\": " << s.first_page_faults
         << ", \"cpu\": " << (s.has_cpu_time ? "true" : "false") << "}";
  }
  file << "]}\n";
  for (const bench::Series& s : all) {
    file.write(reinterpret_cast<const char*>(s.timings.data()),
               static_cast<std::streamsize>(s.timings.size() * sizeof(bench::CallTiming)));
  }
  if (!file.flush()) throw Error(std::string(path) + ": could not be written");
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4) {
    std::puts("usage: surefoot_tick_bench NAME.robot LOW_STATES OUT [--form F] [--passes N] ...");
    return 2;
  }
  try {
    const bench::ReplayPlan plan = read_plan(argc, argv);
    // The system may forbid locking; page faults are counted in both cases.
    const bool locked = mlockall(MCL_CURRENT | MCL_FUTURE) == 0;
    std::vector<bench::Series> all;
    all.push_back(bench::time_ticks(plan));
    all.push_back(bench::time_paced_ticks(plan));
    all.push_back(bench::time_state_to_torque(plan));
    all.push_back(bench::time_null(plan, median(all.front())));
    for (bench::Series& stage : bench::time_stages(plan)) all.push_back(std::move(stage));
    write_series(argv[3], all, locked);
  } catch (const Error& problem) {
    std::cerr << problem.what() << "\n";
    return 1;
  }
  return 0;
}
