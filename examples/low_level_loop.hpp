// SPDX-License-Identifier: BSD-3-Clause
// Common part of the low-level examples: a 500 Hz loop over UDP with the power protection.
#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <string>
#include <surefoot/surefoot.hpp>
#include <thread>

namespace example {

using namespace surefoot;
constexpr std::chrono::milliseconds kPeriod(2);

// Writes cmd in tick n = 1, 2 ...
using Control = std::function<void(int n, const LowState& state, LowCmd& cmd)>;

inline volatile std::sig_atomic_t interrupted = 0;

// Send damping for 0.2 s. Call it before every exit, because the motors keep their last command.
inline void damp(UdpLink& link) {
  for (int k = 0; k < 100; ++k, std::this_thread::sleep_for(kPeriod)) {
    link.send(damping_low_cmd(3.0));
  }
}

inline bool wait_for_robot(UdpLink& link) {
  for (int k = 0; k < 1000 && !interrupted; ++k, std::this_thread::sleep_for(kPeriod)) {
    link.send(init_low_cmd());  // the link sends damping until the first valid LowState
    if (link.receive()) return true;
  }
  if (link.counts().received > 0) {
    std::printf("no valid LowState: %s\n", to_text(link.last_reject()).c_str());
  } else {
    std::puts("no robot: no answer within 2 s");
  }
  return false;
}

// Run the loop for the duration [s]. Returns 0; 1 if LowStates stop; 255 after a trip of the power
// protection, as exit(-1) in the SDK's examples.
inline int loop(UdpLink& link, Safety& safety, double duration, const Control& control,
                int protect_from_tick) {
  LowCmd cmd = init_low_cmd();
  const float hip_tau[] = {-0.65F, 0.65F, -0.65F, 0.65F};
  auto next_tick_time = std::chrono::steady_clock::now();
  for (int n = 1; n <= duration / 0.002 && !interrupted; ++n) {
    const bool has_new_state = link.receive();
    if (link.state_age() > 0.1) {  // [s] the robot damps after the same time without a command
      std::printf("tick %d: no LowState for %.0f ms; damping\n", n, 1000.0 * link.state_age());
      return 1;
    }
    for (int leg = 0; leg < kLegs; ++leg) cmd.motorCmd[3 * leg].tau = hip_tau[leg];
    control(n, link.state(), cmd);
    // Check each LowState only once.
    if (has_new_state && n >= protect_from_tick && safety.power_protect(cmd, link.state(), 1) < 0) {
      std::printf("tick %d: power protection, %.0f W; damping\n", n, safety.power());
      return 255;
    }
    link.send(cmd);
    std::this_thread::sleep_until(next_tick_time += kPeriod);
  }
  return 0;
}

// Run an example. Arguments: NAME.robot [--host A] [--port N] [--sdk GENERATION] [--duration S].
// power_protect() at level 1 checks each sample from tick `protect_from_tick` on. Returns the exit
// status.
inline int run(int argc, char** argv, const Control& control, int protect_from_tick) {
  if (argc < 2) {
    std::printf("usage: %s NAME.robot [--host A] [--port N] [--sdk GENERATION] [--duration S]\n",
                argv[0]);
    return 2;
  }
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
    std::signal(number, [](int) { interrupted = 1; });
  }
  try {
    UdpLinkOptions options;
    double duration = 10.0;
    for (int k = 2; k + 1 < argc; k += 2) {
      if (!std::strcmp(argv[k], "--host")) options.host = argv[k + 1];
      if (!std::strcmp(argv[k], "--port")) options.port = std::atoi(argv[k + 1]);
      if (!std::strcmp(argv[k], "--sdk")) options.generation = to_generation(argv[k + 1]);
      if (!std::strcmp(argv[k], "--duration")) duration = std::atof(argv[k + 1]);
    }
    Safety safety(Robot::load(argv[1]));
    UdpLink link(options);
    std::puts("Make sure the robot is hung up.");
    if (!wait_for_robot(link)) return 1;
    const int status = loop(link, safety, duration, control, protect_from_tick);
    damp(link);
    return status;
  } catch (const Error& problem) {
    std::printf("%s\n", problem.what());
    return 1;
  }
}

}  // namespace example
