// SPDX-License-Identifier: BSD-3-Clause
#include <nanobind/stl/array.h>
#include <nanobind/stl/string.h>

#include <chrono>
#include <future>
#include <limits>
#include <optional>

#include "bindings.hpp"
#include "surefoot/error.hpp"
#include "surefoot/stand_runner.hpp"

namespace nb = nanobind;
using namespace nb::literals;
using namespace surefoot;

namespace {

void bind_snapshot(nb::module_& m) {
  nb::class_<RunSnapshot>(m, "RunSnapshot", "A look at a StandRunner's loop.")
      .def_prop_ro(
          "phase", [](const RunSnapshot& s) { return to_string(s.phase); },
          "waiting, passive, rising, standing, sitting, damping or ended.")
      .def_prop_ro(
          "reason", [](const RunSnapshot& s) { return to_string(s.reason); },
          "Of the last damping or of the end: none, asked, no_state, wrong_generation, stale, "
          "away, restart, controller, power_protect, button or fault (see damping_fault).")
      .def_prop_ro(
          "last_reject", [](const RunSnapshot& s) { return to_text(s.last_reject); },
          "Why the last bad datagram was not taken.")
      .def_ro("mode", &RunSnapshot::mode, "Of the supervisor.")
      .def_ro("damping_fault", &RunSnapshot::damping_fault, "Why the supervisor damped last.")
      .def_ro("faults", &RunSnapshot::faults, "Which there are and have been.")
      .def_ro("arming", &RunSnapshot::arming, "What passes and what does not.")
      .def_ro("armed", &RunSnapshot::armed)
      .def_ro("stood", &RunSnapshot::stood, "Has it stood at all?")
      .def_ro(
          "stood_to_end", &RunSnapshot::stood_to_end,
          "Has it stood, and lain down because it was asked to (start STANDING: stood on), until "
          "the end?")
      .def_ro("rise_failed", &RunSnapshot::rise_failed, "Has the last rise given up?")
      .def_ro("rise_progress", &RunSnapshot::rise_progress, "From lying (0) to standing (1).")
      .def_ro("rise_stage", &RunSnapshot::rise_stage, "Of the last rise.")
      .def_ro("controller_status", &RunSnapshot::controller_status,
              "Of the controller's last tick.")
      .def_ro("controller_fault", &RunSnapshot::controller_fault, "Of the controller.")
      .def_ro("link", &RunSnapshot::link, "Counts of the link.")
      .def_ro("time", &RunSnapshot::time, "[s] since run() began.")
      .def_ro("state_age", &RunSnapshot::state_age, "[s] of the newest LowState.")
      .def_ro("ticks", &RunSnapshot::ticks, "Of control.")
      .def_ro("usable_ticks", &RunSnapshot::usable_ticks, "Of those, with a fresh command.")
      .def_ro("ticks_without_state", &RunSnapshot::ticks_without_state,
              "Of those, without a new LowState.")
      .def_ro("silence_time", &RunSnapshot::silence_time,
              "[s] that robot or program was silent: stale, away.")
      .def_ro("saturated_ticks", &RunSnapshot::saturated_ticks,
              "Of those, with a motor at its limit.")
      .def_ro("missed_periods", &RunSnapshot::missed_periods,
              "Periods left out: a tick or the system was late.")
      .def_ro("dampings", &RunSnapshot::dampings, "Times that it latched.")
      .def_ro("resumed_dampings", &RunSnapshot::resumed_dampings,
              "Of those, left because the robot's clock had stood still with it.")
      .def_ro("rearms", &RunSnapshot::rearms, "Times that it began anew.")
      .def_ro("refused_rearms", &RunSnapshot::refused_rearms,
              "By rearm(): no state came, or checks failed.")
      .def_ro("measured_power", &RunSnapshot::measured_power,
              "[W] that the protection judged last.")
      .def_ro("power_at_damping", &RunSnapshot::power_at_damping,
              "[W] the same, when it damped last.")
      .def_ro("greatest_power", &RunSnapshot::greatest_power, "[W] that it ever judged.")
      .def_ro("height", &RunSnapshot::height, "[m] estimated.")
      .def_ro("tilt", &RunSnapshot::tilt, "[rad] estimated.")
      .def_ro("q", &RunSnapshot::q, "(19,) Pinocchio's, estimated.")
      .def_ro("joint_angles", &RunSnapshot::joint_angles,
              "(12,) [rad] as reported, SDK motor order.")
      .def_ro("desired_forces", &RunSnapshot::desired_forces,
              "(12,) [N] asked of FR FL RR RL, each x y z, world axes.")
      .def_ro("contact", &RunSnapshot::contact, "(4,) belief that each foot bears.")
      .def_ro("position_error", &RunSnapshot::position_error, "[m] of the base from its reference.")
      .def_ro("orientation_error", &RunSnapshot::orientation_error,
              "[rad] of the base from its reference.")
      .def_ro("torque_ratio", &RunSnapshot::torque_ratio, "Greatest share of its limit in tauEst.")
      .def_ro("command_power", &RunSnapshot::command_power,
              "[W] sum |tau dq| that the last command takes.")
      .def_ro("tick_p50", &RunSnapshot::tick_p50,
              "[us] from waking to the command sent, of half of the ticks.")
      .def_ro("tick_p90", &RunSnapshot::tick_p90,
              "[us] from waking to the command sent, of 90 % of the ticks.")
      .def_ro("tick_p99", &RunSnapshot::tick_p99,
              "[us] from waking to the command sent, of 99 % of the ticks.")
      .def_ro("tick_p999", &RunSnapshot::tick_p999,
              "[us] from waking to the command sent, of 99.9 % of the ticks.")
      .def_ro("tick_max", &RunSnapshot::tick_max,
              "[us] from waking to the command sent, of all of the ticks.")
      .def_ro("wake_p50", &RunSnapshot::wake_p50,
              "[us] from the deadline to waking, of half of the ticks.")
      .def_ro("wake_p99", &RunSnapshot::wake_p99,
              "[us] from the deadline to waking, of 99 % of the ticks.")
      .def_ro("wake_p999", &RunSnapshot::wake_p999,
              "[us] from the deadline to waking, of 99.9 % of the ticks.")
      .def_ro("wake_max", &RunSnapshot::wake_max,
              "[us] from the deadline to waking, of all of the ticks.");
}

// Python's signal handlers run in its main thread only, between its own instructions.
void run_and_handle_signals(StandRunner& runner) {
  std::future<void> loop = std::async(std::launch::async, [&runner] { runner.run(); });
  const auto ended = [&loop] {
    const nb::gil_scoped_release gil_release;
    return loop.wait_for(std::chrono::milliseconds(20)) == std::future_status::ready;
  };
  std::optional<nb::python_error> interruption;
  while (!ended()) {
    if (PyErr_CheckSignals() == 0) continue;
    interruption ? runner.stop() : runner.finish();
    interruption.emplace();
  }
  if (interruption) throw *interruption;
  loop.get();
}

void bind_runner(nb::module_& m) {
  nb::class_<RunOptions>(m, "RunOptions", "How a StandRunner's loop runs.")
      .def(
          "__init__",
          [](RunOptions* o, double rate, double duration, int power_level, bool remote,
             double connect_timeout, Start start, double operator_timeout, double log_time) {
            new (o) RunOptions{rate,  duration,         power_level, remote, connect_timeout,
                               start, operator_timeout, log_time};
          },
          "rate"_a = 500.0, "duration"_a = std::numeric_limits<double>::infinity(),
          "power_level"_a = 1, "remote"_a = true, "connect_timeout"_a = 5.0,
          "start"_a = Start::kStanding,
          "operator_timeout"_a = std::numeric_limits<double>::infinity(), "log_time"_a = 0.0)
      .def_rw("rate", &RunOptions::rate, "[Hz] of the control loop.")
      .def_rw("duration", &RunOptions::duration,
              "[s] from when it stands first, then finish(); inf: until finish() or stop().")
      .def_rw("power_level", &RunOptions::power_level, "Of power_protect(); 0 switches it off.")
      .def_rw("remote", &RunOptions::remote, "Sticks move the body, button B damps.")
      .def_rw("connect_timeout", &RunOptions::connect_timeout,
              "[s] to wait for the first valid LowState.")
      .def_rw("start", &RunOptions::start, "STANDING: taken over at once; LYING: behind arming.")
      .def_rw("operator_timeout", &RunOptions::operator_timeout,
              "[s] without heartbeat(), which another thread calls, before the robot sits down; "
              "inf: nobody need be there.")
      .def_rw("log_time", &RunOptions::log_time,
              "[s] of ticks that log() keeps, 1.7 kB each; 0 .. 600.");
  nb::class_<StandRunner>(m, "StandRunner",
                          "Runs a Supervisor over UDP at a fixed rate.\n\n"
                          "It begins and ends with damping frames; a latched damping is left by "
                          "arm() alone.")
      .def(
          "__init__",
          [](StandRunner* self, const Robot& robot, const std::string& host, int port,
             const std::string& generation, int local_port, const Gains* gains,
             const StandOptions& stand, const RunOptions& options, bool real_robot) {
            const Gains& used = gains ? *gains : robot.config().gains;
            new (self) StandRunner(
                robot, used, stand,
                {host, port, local_port, to_generation(generation), used.damping_kd, real_robot},
                options);
          },
          "robot"_a, "host"_a = "127.0.0.1", "port"_a = 8007, "generation"_a = "go1-v3.8",
          "local_port"_a = 0, "gains"_a = nb::none(), "stand"_a = StandOptions(),
          "options"_a = RunOptions(), "real_robot"_a = false,
          "Raise Error: an invalid option, a real robot that is not started lying, or what UdpLink "
          "raises.\nreal_robot: may the host be beyond this machine?")
      .def("run", &run_and_handle_signals,
           "Run until stop(), finish(), or a robot that cannot be controlled.\n\n"
           "The loop has a thread of its own; Ctrl-C is finish(), a second one stop(); then "
           "KeyboardInterrupt is raised. Raise Error if it was called before.")
      .def("request", &StandRunner::request, "mode"_a,
           "Ask for a mode as of a Supervisor; from any thread.")
      .def("arm", &StandRunner::arm, "As a Supervisor's; from any thread.")
      .def("finish", &StandRunner::finish,
           "Sit down if it was started lying, then damp, and end; from any thread.")
      .def("stop", &StandRunner::stop, "Damp, and end; from any thread.")
      .def("damp", &StandRunner::damp, "Damp, and stay; from any thread.")
      .def("heartbeat", &StandRunner::heartbeat, "Say that the operator is there; from any thread.")
      .def("rearm", &StandRunner::rearm, "arm() whose refusals the snapshot counts.")
      .def("set_gains", &StandRunner::set_gains, "gains"_a,
           "As StandController's, with the next tick; from any thread. Raise Error if one is "
           "invalid.")
      .def(
          "set_body_reference", &StandRunner::set_body_reference, "target"_a,
          "As StandController's, with the next tick; the remote's sticks add to it. Forgotten when "
          "the robot stands anew. From any thread.")
      .def("log", &StandRunner::log, nb::rv_policy::reference_internal,
           "The last RunOptions.log_time of ticks, from the robot's first report on.\n\n"
           "Until 5 s (half of log_time, where that is less) after it was last driven: what brakes "
           "for longer has happened. Raise Error while run() runs.")
      .def("snapshot", &StandRunner::snapshot, "What was last published, from any thread.")
      .def_prop_ro("real_time", &StandRunner::real_time, "Scheduling and memory it got, in words.")
      .def_prop_ro("local_port", &StandRunner::local_port, "Ours.");
}

}  // namespace

void bind_run(nb::module_& m) {
  bind_snapshot(m);
  bind_runner(m);
}
