// SPDX-License-Identifier: BSD-3-Clause
// Runs one solver over one sequence of QPs. Usage: PROGRAM describe, or
//   PROGRAM SEQUENCE warm|cold RECORDS REFERENCE|- [TOLERANCE [ANSWERS]]
// Input files: SEQUENCE, and REFERENCE with the reference answers (-: there are none).
// Output files: RECORDS, and ANSWERS with the answers of this run.
// Exit status: 0 after the last QP, 2 for an error, 3 if the solver has no warm start.
// Only solve() is timed. The QP is copied just before solve(), so that it is in the processor's
// cache, as after a controller has computed it.
#include <cmath>
#include <cstdio>
#include <ctime>
#include <exception>
#include <fstream>

#include "allocation_count.hpp"
#include "records.hpp"
#include "residuals.hpp"
#include "sequence_file.hpp"

namespace {

using namespace bench;

double nanoseconds(clockid_t clock) {
  timespec t{};
  clock_gettime(clock, &t);
  return 1e9 * double(t.tv_sec) + double(t.tv_nsec);
}

// Return NaN for all values that the file does not have.
std::vector<double> read_reference(const std::string& path, std::size_t count) {
  std::vector<double> answers(count, std::nan(""));
  std::ifstream file(path, std::ios::binary);
  file.read(reinterpret_cast<char*>(answers.data()), std::streamsize(8 * count));
  return answers;
}

// The times include the reading of the clocks; the null adapter measures this overhead.
Record time_solve(Adapter& adapter) {
  Record record{};
  const long before = allocations();
  count_allocations(true);
  const double cpu = nanoseconds(CLOCK_THREAD_CPUTIME_ID);
  const double wall = nanoseconds(CLOCK_MONOTONIC);
  const SolveStatus status = adapter.solve();
  record.wall_ns = nanoseconds(CLOCK_MONOTONIC) - wall;
  record.cpu_ns = nanoseconds(CLOCK_THREAD_CPUTIME_ID) - cpu;
  count_allocations(false);
  record.allocations = double(allocations() - before);
  record.status = double(status);
  record.iterations = adapter.iterations();
  return record;
}

void add_residuals(const Problem& problem, const Solution& solution, const double* reference,
                   Record& record) {
  const Residuals r = residuals(problem, solution);
  record.primal = r.primal;
  record.dual = r.dual;
  record.gap = r.gap;
  record.distance = 0.0;
  for (int j = 0; j < problem.n; ++j) {
    const double distance = std::abs(solution.x[j] - reference[j]);
    if (!(distance <= record.distance)) record.distance = distance;  // propagates NaN
  }
}

int describe() {
  Setup setup;
  setup.n = 1;
  const Description d = make_adapter(setup)->describe();
  std::printf("%s\n%s\n%s\n%s\n%s\n", d.name.c_str(), d.interface.c_str(), d.version.c_str(),
              d.settings.c_str(), d.warm_start.c_str());
  return 0;
}

int run(int count, char** words) {
  SequenceFile sequence(words[1]);
  Setup setup;
  setup.n = sequence.first_problem().n;
  setup.n_eq = sequence.first_problem().n_eq;
  setup.n_in = sequence.first_problem().n_in;
  setup.warm = std::string(words[2]) == "warm";
  if (count > 5) setup.tolerance = std::stod(words[5]);
  sequence.find_patterns(setup);
  const std::unique_ptr<Adapter> adapter = make_adapter(setup);
  if (setup.warm && !adapter->can_warm_start()) return 3;
  RecordFile records(words[3], sequence.ticks());
  const std::vector<double> reference =
      read_reference(words[4], std::size_t(sequence.ticks()) * setup.n);
  std::ofstream written;
  if (count > 6) written.open(words[6], std::ios::binary);
  Solution solution{std::vector<double>(setup.n), std::vector<double>(setup.n_eq),
                    std::vector<double>(setup.n_in)};
  adapter->clear_warm_start();
  for (int tick = 0; tick < sequence.ticks(); ++tick) {
    if (!setup.warm) adapter->clear_warm_start();
    const Problem& problem = sequence.load(tick);
    adapter->load_problem(problem);
    Record record = time_solve(*adapter);
    adapter->read_solution(solution);
    add_residuals(problem, solution, &reference[std::size_t(tick) * setup.n], record);
    records[tick] = record;
    written.write(reinterpret_cast<const char*>(solution.x.data()), std::streamsize(8 * setup.n));
  }
  return 0;
}

}  // namespace

int main(int count, char** words) {
  try {
    if (count == 2 && std::string(words[1]) == "describe") return describe();
    if (count >= 5) return run(count, words);
    std::fprintf(stderr,
                 "expected: describe, or "
                 "SEQUENCE warm|cold RECORDS REFERENCE|- [TOLERANCE [ANSWERS]]\n");
  } catch (const std::exception& problem) {
    std::fprintf(stderr, "%s\n", problem.what());
  }
  return 2;
}
