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
  nb::class_<RunSnapshot>(
      m, "RunSnapshot",
      "State of a StandRunner, published every 50 ms and at every change of phase.\n\n"
      "armed is true if the robot is armed.")
      .def_prop_ro(
          "phase", [](const RunSnapshot& s) { return to_string(s.phase); },
          "Phase: waiting, passive, rising, standing, sitting, damping or ended.")
      .def_prop_ro(
          "reason", [](const RunSnapshot& s) { return to_string(s.reason); },
          "Reason of the last damping, or of the end of the run, in one word.\n\n"
          "none; asked: stop(), finish() or damp() was called, or the duration is over;\n"
          "no_state: no valid LowState arrived in time, or before the end;\n"
          "wrong_generation: the robot sends frames of another generation; stale: LowStates\n"
          "stopped arriving; away: this process stalled for more than 100 ms; restart: the\n"
          "robot restarted, so it is not the one that was armed; controller: the\n"
          "StandController damps, see controller_fault; power_protect: the power protection\n"
          "tripped; button: button B on the remote; fault: another fault, see\n"
          "damping_fault.")
      .def_prop_ro(
          "last_reject", [](const RunSnapshot& s) { return to_text(s.last_reject); },
          "Why the last invalid datagram was rejected, in a sentence.")
      .def_ro("mode", &RunSnapshot::mode, "Mode of the supervisor.")
      .def_ro("damping_fault", &RunSnapshot::damping_fault,
              "Why the supervisor last latched damping.")
      .def_ro("faults", &RunSnapshot::faults, "Active and past faults.")
      .def_ro("arming", &RunSnapshot::arming, "Arming checks.")
      .def_ro("armed", &RunSnapshot::armed)
      .def_ro("stood", &RunSnapshot::stood, "True if the robot has stood in this run.")
      .def_ro("stood_to_end", &RunSnapshot::stood_to_end,
              "True if the robot stood and the run ended on request.\n\n"
              "No fault damped it or made it sit down afterwards. With start LYING it lay down\n"
              "before the end, with STANDING it stood.")
      .def_ro("rise_failed", &RunSnapshot::rise_failed, "True if the last rise gave up.")
      .def_ro("rise_progress", &RunSnapshot::rise_progress, "From lying (0) to standing (1).")
      .def_ro("rise_stage", &RunSnapshot::rise_stage,
              "Stage of the present rise, or of the last one.")
      .def_ro("controller_status", &RunSnapshot::controller_status,
              "StandController.status of its last tick.")
      .def_ro("controller_fault", &RunSnapshot::controller_fault, "StandController.fault.")
      .def_ro("link", &RunSnapshot::link, "Datagram counts of the link.")
      .def_ro("time", &RunSnapshot::time, "Time since run() began [s].")
      .def_ro("state_age", &RunSnapshot::state_age, "Age of the newest LowState [s].")
      .def_ro("ticks", &RunSnapshot::ticks, "Control ticks, those in damping not counted.")
      .def_ro("usable_ticks", &RunSnapshot::usable_ticks, "Of these, ticks with a fresh command.")
      .def_ro("ticks_without_state", &RunSnapshot::ticks_without_state,
              "Of these, ticks without a new LowState.")
      .def_ro("silence_time", &RunSnapshot::silence_time,
              "Silence of the robot or of this process, when last detected [s].")
      .def_ro("saturated_ticks", &RunSnapshot::saturated_ticks,
              "Of these, standing with torques or power at a limit.")
      .def_ro("missed_periods", &RunSnapshot::missed_periods,
              "Periods left out because a tick or the system took too long.")
      .def_ro("dampings", &RunSnapshot::dampings, "Times that damping was latched.")
      .def_ro("resumed_dampings", &RunSnapshot::resumed_dampings,
              "Of these, ended because the robot's clock had paused too.")
      .def_ro("rearms", &RunSnapshot::rearms, "Times that arming left latched damping.")
      .def_ro("refused_rearms", &RunSnapshot::refused_rearms,
              "rearm() calls that were refused: no LowState, or not ready.")
      .def_ro("measured_power", &RunSnapshot::measured_power,
              "Last power judged by the power protection [W].")
      .def_ro("power_at_damping", &RunSnapshot::power_at_damping,
              "measured_power when damping was last latched [W].")
      .def_ro("greatest_power", &RunSnapshot::greatest_power,
              "Largest measured_power outside damping [W].")
      .def_ro("height", &RunSnapshot::height,
              "Estimated height of the base origin [m], world frame.")
      .def_ro("tilt", &RunSnapshot::tilt, "Estimated angle between base z and world z [rad].")
      .def_ro("q", &RunSnapshot::q, "Estimated q, Pinocchio's order, 19 numbers.")
      .def_ro("joint_angles", &RunSnapshot::joint_angles,
              "Joint angles as reported [rad], 12 numbers, SDK motor order.")
      .def_ro("desired_forces", &RunSnapshot::desired_forces,
              "Force of the ground on the feet by the QP [N], 12 numbers: FR FL RR RL, each x y\n"
              "z, world axes.")
      .def_ro("contact", &RunSnapshot::contact,
              "Contact confidence 0 .. 1, 4 numbers, FR FL RR RL.")
      .def_ro("position_error", &RunSnapshot::position_error,
              "Distance of the base from its reference position [m].")
      .def_ro("orientation_error", &RunSnapshot::orientation_error,
              "Angle of the base from its reference orientation [rad].")
      .def_ro("torque_ratio", &RunSnapshot::torque_ratio,
              "Largest |tauEst| / tau_max of the motors.")
      .def_ro("command_power", &RunSnapshot::command_power, "StandController.command_power [W].")
      .def_ro("tick_p50", &RunSnapshot::tick_p50,
              "Latency from waking up to the command sent [us], median.")
      .def_ro("tick_p90", &RunSnapshot::tick_p90,
              "Latency from waking up to the command sent [us], 90 % quantile.")
      .def_ro("tick_p99", &RunSnapshot::tick_p99,
              "Latency from waking up to the command sent [us], 99 % quantile.")
      .def_ro("tick_p999", &RunSnapshot::tick_p999,
              "Latency from waking up to the command sent [us], 99.9 % quantile.")
      .def_ro("tick_max", &RunSnapshot::tick_max,
              "Latency from waking up to the command sent [us], maximum.")
      .def_ro("wake_p50", &RunSnapshot::wake_p50,
              "Latency from the deadline to waking up [us], median.")
      .def_ro("wake_p99", &RunSnapshot::wake_p99,
              "Latency from the deadline to waking up [us], 99 % quantile.")
      .def_ro("wake_p999", &RunSnapshot::wake_p999,
              "Latency from the deadline to waking up [us], 99.9 % quantile.")
      .def_ro("wake_max", &RunSnapshot::wake_max,
              "Latency from the deadline to waking up [us], maximum.");
}

// Python runs signal handlers only in its main thread and between bytecode instructions. So the
// loop gets its own thread, and this one polls for signals.
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
  nb::class_<RunOptions>(
      m, "RunOptions",
      "Options of a StandRunner. StandRunner() raises Error if one is out of range.")
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
      .def_rw("rate", &RunOptions::rate, "Rate of the control loop [Hz], 100 .. 1000.")
      .def_rw("duration", &RunOptions::duration,
              "Time from first standing to finish() [s]; inf: until finish() or stop().")
      .def_rw("power_level", &RunOptions::power_level,
              "Level of Safety.power_protect(), 1 .. 10; 0 switches it off (start STANDING\n"
              "only).")
      .def_rw("remote", &RunOptions::remote,
              "True: the sticks of the remote move the body, and button B damps.")
      .def_rw("connect_timeout", &RunOptions::connect_timeout,
              "Longest wait for the first valid LowState [s].")
      .def_rw("start", &RunOptions::start,
              "STANDING: take over a standing robot at once. LYING: arming checks first.")
      .def_rw("operator_timeout", &RunOptions::operator_timeout,
              "Time without heartbeat() after which the robot sits down [s], at least 0.01.\n\n"
              "inf needs no operator. Another thread than run() calls heartbeat().")
      .def_rw("log_time", &RunOptions::log_time,
              "Time of ticks that log() keeps [s], 1.7 kB each; 0 .. 600.");
  nb::class_<StandRunner>(
      m, "StandRunner",
      "Loop that runs a Supervisor over UDP at a fixed rate.\n\n"
      "With RunOptions.start STANDING, the runner takes over a standing robot with its\n"
      "first valid LowState. With LYING, arm() and request() arm the robot and let it\n"
      "rise and sit down. Deadlines are absolute; SCHED_FIFO and locked memory are used\n"
      "where the system permits. A run begins and ends with damping commands.\n\n"
      "Without a new LowState, the last command is repeated for at most 10 ms; then the\n"
      "motors damp, and after 20 ms damping is latched. Only arm() leaves latched\n"
      "damping, with one exception: a LowState within 100 ms whose tick shows that the\n"
      "robot's clock paused too. If the system keeps this process from running for more\n"
      "than 100 ms, damping is latched too; after a shorter stall the run continues\n"
      "with the newest LowState.")
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
          "Open the link to the robot; run() starts the loop.\n\n"
          "Args:\n"
          "    robot: Model and configuration, twelve joints on a free base.\n"
          "    host: IPv4 address or name; a real robot: 192.168.123.10.\n"
          "    port: UDP port of the robot, 1 .. 65535.\n"
          "    generation: Frame format, one of surefoot.protocol.GENERATIONS.\n"
          "    local_port: Local UDP port; 0: any free port.\n"
          "    gains: None: those of robot.config.\n"
          "    stand: Options of the StandController.\n"
          "    options: Options of the loop.\n"
          "    real_robot: True: host need not be a loopback address; needs start LYING.\n\n"
          "Raises:\n"
          "    Error: An option or a gain is invalid, a real robot is not started LYING,\n"
          "        the host or the generation is unknown, the host is not a loopback\n"
          "        address and real_robot is False, or a port is out of range, in use or\n"
          "        not permitted.")
      .def("run", &run_and_handle_signals,
           "Run the loop until stop() or finish(), the end of the duration, no valid\n"
           "LowState within connect_timeout, or a robot of another generation.\n\n"
           "The loop runs in a thread of its own. Ctrl-C calls finish(), a second Ctrl-C\n"
           "stop(); then KeyboardInterrupt is raised. Raises Error if it was called before.")
      .def("request", &StandRunner::request, "mode"_a,
           "Request a mode, see Supervisor.request(). From any thread.")
      .def("arm", &StandRunner::arm, "Arm the robot, see Supervisor.arm(). From any thread.")
      .def("finish", &StandRunner::finish,
           "Start LYING: sit down, damp and end the run; else stop(). From any thread.")
      .def("stop", &StandRunner::stop, "Damp and end the run. From any thread.")
      .def("damp", &StandRunner::damp, "Damp, latched; the run goes on. From any thread.")
      .def("heartbeat", &StandRunner::heartbeat,
           "Signal that the operator is present, see RunOptions.operator_timeout.\n\n"
           "From any other thread than that of the loop. Real-time: yes.")
      .def("rearm", &StandRunner::rearm,
           "Call arm(); RunSnapshot.refused_rearms counts refusals. From any thread.")
      .def("set_gains", &StandRunner::set_gains, "gains"_a,
           "Set the gains, see StandController.set_gains(); they take effect in the next\n"
           "tick.\n\n"
           "From any thread. Raises Error if a gain is invalid.")
      .def("set_body_reference", &StandRunner::set_body_reference, "target"_a,
           "Set the target pose, see StandController.set_body_reference().\n\n"
           "It takes effect in the next tick; the sticks of the remote add to it. It applies\n"
           "while the robot stands, and is cleared when the robot stands up again. From any\n"
           "thread.")
      .def("log", &StandRunner::log, nb::rv_policy::reference_internal,
           "Return the last RunOptions.log_time of ticks, a reference.\n\n"
           "The log begins with the first LowState. It stops 5 s after the robot was last in\n"
           "motion or standing (half of log_time if that is less), so that a robot that\n"
           "damps for long keeps the ticks before. Raises Error while run() is running.")
      .def("snapshot", &StandRunner::snapshot,
           "Return a copy of the state last published. From any thread.")
      .def_prop_ro("real_time", &StandRunner::real_time,
                   "Scheduling and memory locking that run() got, in words; empty before run().")
      .def_prop_ro("local_port", &StandRunner::local_port, "Local UDP port.");
}

}  // namespace

void bind_run(nb::module_& m) {
  bind_snapshot(m);
  bind_runner(m);
}
