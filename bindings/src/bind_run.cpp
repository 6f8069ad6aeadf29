// SPDX-License-Identifier: BSD-3-Clause
#include <nanobind/stl/array.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/string.h>

#include <chrono>
#include <future>
#include <limits>
#include <optional>

#include "bindings.hpp"
#include "surefoot/error.hpp"
#include "surefoot/runner.hpp"
#include "value_class.hpp"

using namespace nb::literals;
using namespace surefoot;

namespace {

std::optional<nb::typed<nb::dict, nb::str, nb::any>> rejected_frame(const FrameReport& report) {
  const bool has_generation = report.status == FrameStatus::kWrongGeneration;
  if (!has_generation && report.status != FrameStatus::kWrongLength) return std::nullopt;
  nb::typed<nb::dict, nb::str, nb::any> frame;
  frame["bytes"] = report.size;
  frame["generation"] = nb::none();
  if (has_generation) frame["generation"] = to_string(report.detected);
  frame["expected_bytes"] = report.expected_size;
  frame["expected_generation"] = to_string(report.expected);
  return frame;
}

void bind_snapshot(nb::module_& m) {
  nb::class_<RunSnapshot>(m, "RunSnapshot",
                          "State of a Runner, published every 50 ms and at every change of phase.")
      .def_prop_ro(
          "phase", [](const RunSnapshot& s) { return to_string(s.phase); },
          "Phase of the run, in one word.\n\n"
          "- waiting: the runner sends damping until the first valid LowState arrives\n"
          "- passive: the motors damp until request(Mode.RISE)\n"
          "- rising: the robot rises\n"
          "- standing: the robot stands\n"
          "- walking: the robot walks, or stands at velocity 0, ready to walk\n"
          "- sitting: the robot sits down\n"
          "- damping: damping is latched, the motors damp until arm()\n"
          "- ended: the run ends after 0.2 s of damping commands")
      .def_prop_ro(
          "reason", [](const RunSnapshot& s) { return to_string(s.reason); },
          "Reason of the last damping, or of the end of the run, in one word.\n\n"
          "- none: there was no damping, and the run has not ended\n"
          "- asked: stop(), finish() or damp() was called, or the duration is over\n"
          "- no_state: no valid LowState arrived within connect_timeout, or before the run\n"
          "  ended\n"
          "- wrong_generation: the robot sends frames of another generation\n"
          "- not_standing: start STANDING, but the robot lies\n"
          "- stale: LowStates stopped arriving\n"
          "- away: this process did not run for more than 100 ms\n"
          "- restart: the robot restarted, so arming is no longer valid\n"
          "- controller: the StandController damps, see controller_fault\n"
          "- power_protect: the power protection tripped\n"
          "- button: button B on the remote was pressed\n"
          "- fault: another fault, see damping_fault")
      .def_prop_ro(
          "last_reject", [](const RunSnapshot& s) { return to_text(s.last_reject); },
          "Reason why the last invalid datagram was rejected, a sentence.")
      .def_prop_ro(
          "rejected_frame", [](const RunSnapshot& s) { return rejected_frame(s.last_reject); },
          "Last rejected datagram if its length was wrong, else None.\n\n"
          "A dictionary: bytes, generation (None: no generation has frames of this length),\n"
          "expected_bytes, expected_generation.")
      .def_ro("mode", &RunSnapshot::mode, "Mode of the supervisor, after the last tick.")
      .def_ro("damping_fault", &RunSnapshot::damping_fault,
              "FaultId for which damping was last latched.")
      .def_ro("faults", &RunSnapshot::faults, "Active and past faults.")
      .def_ro("arming", &RunSnapshot::arming, "Results of the arming checks.")
      .def_ro("armed", &RunSnapshot::armed, "True if the robot is armed.")
      .def_ro("stood", &RunSnapshot::stood, "True if the robot has stood in this run.")
      .def_ro("stood_to_end", &RunSnapshot::stood_to_end,
              "True if the run was completed as requested.\n\n"
              "This means that the robot stood, that after this no fault made it damp or sit\n"
              "down, and that the run ended on request. At the end the robot was standing\n"
              "(start STANDING) or had lain down (start LYING).")
      .def_ro("rise_failed", &RunSnapshot::rise_failed, "True if the last rise was given up.")
      .def_ro("rise_progress", &RunSnapshot::rise_progress,
              "Reference position on the path from lying (0) to standing (1).")
      .def_ro("rise_stage", &RunSnapshot::rise_stage,
              "Stage of the present rise, or of the last one.")
      .def_ro("controller_status", &RunSnapshot::controller_status,
              "StandController.status after its last tick.")
      .def_ro("controller_fault", &RunSnapshot::controller_fault, "StandController.fault.")
      .def_ro("link", &RunSnapshot::link, "Datagram counts of the link.")
      .def_ro("time", &RunSnapshot::time, "Time since run() began [s].")
      .def_ro("state_age", &RunSnapshot::state_age, "Age of the newest LowState [s].")
      .def_ro("ticks", &RunSnapshot::ticks, "Number of control ticks outside damping.")
      .def_ro("usable_ticks", &RunSnapshot::usable_ticks,
              "Number of ticks, out of `ticks`, with a command computed from a new LowState.")
      .def_ro("ticks_without_state", &RunSnapshot::ticks_without_state,
              "Number of ticks, out of `ticks`, without a new LowState.")
      .def_ro("silence_time", &RunSnapshot::silence_time,
              "Length of the last gap [s] in which no LowState arrived or this process did not\n"
              "run.")
      .def_ro("saturated_ticks", &RunSnapshot::saturated_ticks,
              "Number of ticks, out of `ticks`, in which the robot stood with a torque or the\n"
              "power at its limit.")
      .def_ro("missed_periods", &RunSnapshot::missed_periods,
              "Number of periods without a tick, because a tick or the system took too long.")
      .def_ro("dampings", &RunSnapshot::dampings, "Number of times that damping was latched.")
      .def_ro("resumed_dampings", &RunSnapshot::resumed_dampings,
              "Number of latched dampings that ended without arm(), because the clock of the\n"
              "robot had paused together with its samples.")
      .def_ro("rearms", &RunSnapshot::rearms, "Number of times that arm() ended latched damping.")
      .def_ro("refused_rearms", &RunSnapshot::refused_rearms,
              "Number of rearm() calls that were refused, because no LowState arrived or the\n"
              "robot was not ready.")
      .def_ro("measured_power", &RunSnapshot::measured_power,
              "Motor power in the last sample that the power protection judged [W].")
      .def_ro("power_at_damping", &RunSnapshot::power_at_damping,
              "measured_power when damping was last latched [W].")
      .def_ro("greatest_power", &RunSnapshot::greatest_power,
              "Largest measured_power outside damping [W].")
      .def_ro("height", &RunSnapshot::height,
              "Estimated height of the base origin above the stance feet [m].")
      .def_ro("tilt", &RunSnapshot::tilt, "Estimated angle between base z and world z [rad].")
      .def_ro("q", &RunSnapshot::q, "Estimated q, Pinocchio's order, 19 numbers, see Robot.")
      .def_ro("joint_angles", &RunSnapshot::joint_angles,
              "Measured joint angles [rad], 12 numbers, SDK motor order.")
      .def_ro("desired_forces", &RunSnapshot::desired_forces,
              "Ground force on each foot in the QP solution [N], world axes, 12 numbers. The\n"
              "order is FR FL RR RL, each x y z.")
      .def_ro("contact", &RunSnapshot::contact,
              "Contact confidence 0 .. 1, 4 numbers, FR FL RR RL.")
      .def_ro("commanded_velocity", &RunSnapshot::commanded_velocity,
              "WalkVelocity that is commanded, clamped; 0 after the timeout.")
      .def_ro("reference_velocity", &RunSnapshot::reference_velocity,
              "WalkVelocity of the reference, which approaches commanded_velocity.")
      .def_ro("velocity_limit", &RunSnapshot::velocity_limit, "WalkLimit of the last velocity.")
      .def_ro("gait", &RunSnapshot::gait, "Gait of the mode WALK.")
      .def_ro("stopping", &RunSnapshot::stopping,
              "True while a robot that walked or stepped stops.")
      .def_ro("start_presses", &RunSnapshot::start_presses,
              "Number of times that START of the remote was pressed.")
      .def_ro("start_answer", &RunSnapshot::start_answer,
              "RequestStatus of the request of the last press of START.")
      .def_ro("position_error", &RunSnapshot::position_error,
              "Distance between the base origin and its reference position [m].")
      .def_ro("orientation_error", &RunSnapshot::orientation_error,
              "Angle between the base and its reference orientation [rad].")
      .def_ro("torque_ratio", &RunSnapshot::torque_ratio,
              "Largest ``|tauEst|`` / tau_max of the motors.")
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
              "Latency from the deadline to waking up [us], maximum.")
      .def("__repr__", [](const RunSnapshot& s) {
        return "RunSnapshot(time=" + value_text(nb::float_(s.time)) + ", phase='" +
               to_string(s.phase) + "', reason='" + to_string(s.reason) +
               "', ticks=" + std::to_string(s.ticks) + ")";
      });
}

// Python runs signal handlers only in its main thread and between bytecode instructions. So the
// loop runs in a thread of its own, and the calling thread polls for signals.
void run_and_handle_signals(Runner& runner) {
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
  ValueClass<RunOptions>(m, "RunOptions",
                         "Options of a Runner. Runner() raises Error if an option is out of\n"
                         "range.")
      .def(
          "__init__",
          [](RunOptions* o, FieldArgument<double> rate, FieldArgument<double> duration,
             FieldArgument<int> power_level, FieldArgument<bool> remote,
             FieldArgument<double> connect_timeout, FieldArgument<Start> start,
             FieldArgument<double> operator_timeout, FieldArgument<double> velocity_timeout,
             FieldArgument<double> log_time) {
            constexpr const char* kType = "RunOptions";
            new (o) RunOptions{rate.to(kType, "rate"),
                               duration.to(kType, "duration"),
                               power_level.to(kType, "power_level"),
                               remote.to(kType, "remote"),
                               connect_timeout.to(kType, "connect_timeout"),
                               start.to(kType, "start"),
                               operator_timeout.to(kType, "operator_timeout"),
                               velocity_timeout.to(kType, "velocity_timeout"),
                               log_time.to(kType, "log_time")};
          },
          "rate"_a = 500.0, "duration"_a = std::numeric_limits<double>::infinity(),
          "power_level"_a = 1, "remote"_a = true, "connect_timeout"_a = 5.0,
          "start"_a = Start::kStanding,
          "operator_timeout"_a = std::numeric_limits<double>::infinity(),
          "velocity_timeout"_a = 0.5, "log_time"_a = 0.0,
          "Create options; the arguments are the attributes.")
      .def_rw("rate", &RunOptions::rate, "Rate of the control loop [Hz], 100 .. 1000.")
      .def_rw("duration", &RunOptions::duration,
              "Time from first standing until finish() is called [s].\n\n"
              "inf: the run ends only with finish() or stop().")
      .def_rw("power_level", &RunOptions::power_level,
              "Level of Safety.power_protect(), 1 .. 10. 0 switches the protection off (start\n"
              "STANDING only).")
      .def_rw("remote", &RunOptions::remote,
              "True if the remote is used.\n\n"
              "Its sticks move the body of a standing robot and give the velocity of a walking\n"
              "one, START begins and ends a walk, SELECT chooses the next gait, and button B\n"
              "damps.")
      .def_rw("connect_timeout", &RunOptions::connect_timeout,
              "Longest wait for the first valid LowState [s].")
      .def_rw("start", &RunOptions::start,
              "State of the robot at the start.\n\n"
              "STANDING: the runner takes over the robot at once. LYING: the robot must pass\n"
              "the arming checks first, and power_level must be 1 .. 10.")
      .def_rw("operator_timeout", &RunOptions::operator_timeout,
              "Time without heartbeat() after which the robot sits down [s], at least 0.01.\n\n"
              "inf: no operator is needed. Call heartbeat() from a thread other than that of\n"
              "run().")
      .def_rw("velocity_timeout", &RunOptions::velocity_timeout,
              "See WalkOptions.velocity_timeout [s].")
      .def_rw("log_time", &RunOptions::log_time,
              "Length of the history that log() returns [s], 0 .. 600. One tick takes 1.7 kB.");
  nb::class_<Runner>(
      m, "Runner",
      "Loop that runs a Supervisor over a link at a fixed rate.\n\n"
      "With RunOptions.start STANDING, the runner takes over a standing robot with its\n"
      "first valid LowState. With LYING, arm() and request() arm the robot and let it\n"
      "rise and sit down. Deadlines are absolute; SCHED_FIFO and locked memory are used\n"
      "where the system permits. A run begins and ends with damping commands.\n\n"
      "Without a new LowState, the last command is repeated for at most 10 ms; then the\n"
      "motors damp, and after 20 ms damping is latched. Only arm() ends latched\n"
      "damping, with one exception: if samples return within 100 ms and their tick\n"
      "shows that the clock of the robot had paused as well, the run continues. Damping\n"
      "is also latched if this process does not run for more than 100 ms. After a\n"
      "shorter pause the run continues with the newest LowState.")
      .def(
          "__init__",
          [](Runner* self, const Robot& robot, const std::string& host, int port,
             const std::string& generation, int local_port, const Gains* gains,
             const ControllerOptions& stand, const RunOptions& options, bool real_robot) {
            const Gains& used = gains ? *gains : robot.config().gains;
            new (self) Runner(
                robot, used, stand,
                {host, port, local_port, to_generation(generation), used.damping_kd, real_robot},
                options);
          },
          "robot"_a, "host"_a = "127.0.0.1", "port"_a = 8007, "generation"_a = "go1-v3.8",
          "local_port"_a = 0, "gains"_a = nb::none(), "stand"_a = ControllerOptions(),
          "options"_a = RunOptions(), "real_robot"_a = false,
          "Open the link to the robot; run() starts the loop.\n\n"
          "Args:\n"
          "    robot: Model and configuration, twelve joints on a free base.\n"
          "    host: IPv4 address or name; 192.168.123.10 for a real robot.\n"
          "    port: UDP port of the robot, 1 .. 65535.\n"
          "    generation: Frame format, one of surefoot.protocol.GENERATIONS.\n"
          "    local_port: Local UDP port; 0: any free port.\n"
          "    gains: Gains to use; None: robot.config.gains.\n"
          "    stand: Options of the StandController.\n"
          "    options: Options of the loop.\n"
          "    real_robot: If True, any host is allowed, and options.start must be LYING.\n\n"
          "Raises:\n"
          "    Error: An option or a gain is invalid, a real robot is not started LYING,\n"
          "        the host or the generation is unknown, the host is not a loopback\n"
          "        address and real_robot is False, or a port is out of range, in use or\n"
          "        not permitted.")
      .def(
          "__init__",
          [](Runner* self, const Robot& robot, const std::shared_ptr<RobotLink>& link,
             const Gains* gains, const ControllerOptions& stand, const RunOptions& options) {
            new (self) Runner(robot, gains ? *gains : robot.config().gains, stand, link, options);
          },
          "robot"_a, "link"_a, "gains"_a = nb::none(), "stand"_a = ControllerOptions(),
          "options"_a = RunOptions(),
          "Use an open link, such as a DdsLink; run() starts the loop.\n\n"
          "Do not use the link until run() has ended.\n\n"
          "Args:\n"
          "    robot: Model and configuration, twelve joints on a free base.\n"
          "    link: Open link to the robot.\n"
          "    gains: Gains to use; None: robot.config.gains.\n"
          "    stand: Options of the StandController.\n"
          "    options: Options of the loop.\n"
          "\n"
          "Raises:\n"
          "    Error: An option or a gain is invalid, or the link allows a real robot and\n"
          "        options.start is not LYING.")
      .def("run", &run_and_handle_signals,
           "Run the loop.\n\n"
           "The loop ends after stop() or finish(), when the duration is over, if no valid\n"
           "LowState arrives within connect_timeout, or if the robot uses another\n"
           "generation.\n\n"
           "The loop runs in a thread of its own. The first Ctrl-C calls finish(), the next\n"
           "Ctrl-C calls stop(). After the loop has ended, KeyboardInterrupt is raised.\n"
           "Raises Error if run() was called before.")
      .def("request", &Runner::request, "mode"_a,
           "Request a mode, see Supervisor.request(). From any thread. Returns the\n"
           "RequestStatus.")
      .def("arm", &Runner::arm,
           "Arm the robot, see Supervisor.arm(). From any thread. Returns the RequestStatus.")
      .def("finish", &Runner::finish,
           "End the run. With RunOptions.start LYING the robot first sits down. With STANDING\n"
           "a walking robot first stops; then this is stop(). From any thread.")
      .def("stop", &Runner::stop, "Damp and end the run. From any thread.")
      .def("damp", &Runner::damp, "Latch damping; the run continues. From any thread.")
      .def("heartbeat", &Runner::heartbeat,
           "Signal that the operator is present, see RunOptions.operator_timeout.\n\n"
           "From any thread except that of the loop. Real-time: yes.")
      .def("rearm", &Runner::rearm,
           "Call arm() and count refusals in RunSnapshot.refused_rearms. From any thread.")
      .def("set_gains", &Runner::set_gains, "gains"_a,
           "Set the gains, see StandController.set_gains(); they take effect in the next\n"
           "tick.\n\n"
           "From any thread. Raises Error if a gain is invalid.")
      .def("set_body_reference", &Runner::set_body_reference, "target"_a,
           "Set the target pose, see StandController.set_body_reference().\n\n"
           "The target takes effect in the next tick, while the robot stands. The sticks of\n"
           "the remote add to the target. It is cleared when the robot stands up again. From\n"
           "any thread.")
      .def("set_velocity", &Runner::set_velocity, "velocity"_a,
           "Set the velocity of a walking robot, see Supervisor.set_velocity().\n\n"
           "It takes effect in the next tick, and is 0 after RunOptions.velocity_timeout. The\n"
           "sticks of the remote add to it. From any thread.")
      .def("set_gait", &Runner::set_gait, "gait"_a,
           "Set the gait, see Supervisor.set_gait(). From any thread.")
      .def("log", &Runner::log, nb::rv_policy::reference_internal,
           "Return the log of the last RunOptions.log_time seconds; not a copy.\n\n"
           "The log begins with the first LowState. It stops 5 s (at most log_time / 2)\n"
           "after the robot last moved or stood. So the ticks before damping are not\n"
           "overwritten while damping lasts. Raises Error while run() is running.")
      .def("snapshot", &Runner::snapshot,
           "Return a copy of the last published snapshot. From any thread.")
      .def_prop_ro("real_time", &Runner::real_time,
                   "Description of the scheduling and memory locking that run() got; empty\n"
                   "before run().")
      .def_prop_ro("local_port", &Runner::local_port, "Local UDP port; 0: the link is no UdpLink.");
}

}  // namespace

void bind_run(nb::module_& m) {
  bind_snapshot(m);
  bind_runner(m);
}
