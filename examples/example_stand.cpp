// SPDX-License-Identifier: BSD-3-Clause
// Stand with the whole-body controller over UDP. `surefoot run` uses the same Runner.
//   surefoot export go1 go1.robot; surefoot robot --robot go1 &
//   example_stand go1.robot [--host A] [--port N] [--sdk GENERATION] [--duration S]
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <surefoot/surefoot.hpp>

using namespace surefoot;

Runner* active_runner = nullptr;  // for the signal handler

int main(int argc, char** argv) {
  if (argc < 2) return std::puts("usage: example_stand NAME.robot [--port N] ..."), 2;
  try {
    UdpLinkOptions link;
    RunOptions options;
    options.duration = 10.0;
    for (int k = 2; k + 1 < argc; k += 2) {
      if (!std::strcmp(argv[k], "--host")) link.host = argv[k + 1];
      if (!std::strcmp(argv[k], "--port")) link.port = std::atoi(argv[k + 1]);
      if (!std::strcmp(argv[k], "--sdk")) link.generation = to_generation(argv[k + 1]);
      if (!std::strcmp(argv[k], "--duration")) options.duration = std::atof(argv[k + 1]);
    }
    const Robot robot = Robot::load(argv[1]);
    Runner runner(robot, robot.config().gains, ControllerOptions(), link, options);
    active_runner = &runner;
    for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
      std::signal(number, [](int) { active_runner->stop(); });  // run() damps, then returns
    }
    runner.run();
    const RunSnapshot end = runner.snapshot();
    std::printf("ended: %s; height %.3f m, tick %.0f us median, %.0f p99.9, %s\n",
                to_string(end.reason), end.height, end.tick_p50, end.tick_p999,
                runner.real_time().c_str());
    return end.reason == RunReason::kRequested ? 0 : 3;
  } catch (const Error& problem) {
    return std::printf("%s\n", problem.what()), 1;
  }
}
