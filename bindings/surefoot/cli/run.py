"""surefoot run: runs the supervisor on a robot, over UDP or DDS."""

from __future__ import annotations

import argparse
import math
import sys
from collections.abc import Callable

from surefoot._core import (
    ControllerOptions,
    Error,
    Mode,
    Robot,
    RunLog,
    Runner,
    RunOptions,
    Start,
)
from surefoot.cli.dds_options import DDS_ROBOTS, default_robot
from surefoot.cli.dds_run import DdsSession
from surefoot.cli.output_files import check_json_path, write_json
from surefoot.cli.robot_choice import chosen_robot
from surefoot.cli.run_log import LOG_TIME, check_log, write_run_log
from surefoot.cli.run_monitor import supervise
from surefoot.cli.run_operator import key_help
from surefoot.cli.run_text import closing_text, lying_text, no_robot_text, run_summary
from surefoot.cli.simulation_arguments import read_form, read_gains
from surefoot.protocol import default_generation
from surefoot.robot.description import RobotDescription
from surefoot.robot.loading import build_robot
from surefoot.system.terminal import LinePrinter, has_keyboard

ENDED_DAMPED = 3  # exit status if the robot did not stand until the requested end
NO_ROBOT = 1  # exit status if no robot of the right generation answered


def run(arguments: argparse.Namespace) -> int:
    """Control the robot until the run ends; print status lines and write JSON.

    Returns:
        Exit status: 0 the robot stood until the requested end; 1 no robot of the right generation
        answered; 3 the run ended in another way.

    Raises:
        Error: A wrong argument.
    """
    check_json_path(arguments.json)
    check_log(arguments.log, arguments.log_time)
    _check_operator(arguments)
    print_line = LinePrinter(sys.stderr if arguments.json == "-" else sys.stdout)
    session = _open_session(arguments, print_line)
    runner, robot, generation = _make_runner(arguments, session)
    where = _where(arguments)
    print_line(
        f"{where}{'' if session else f' from port {runner.local_port}'}, {generation}, "
        f"{arguments.rate:g} Hz, power level {arguments.power_level}; {key_help(arguments.rise)}; "
        "Ctrl-C "
        + ("sits down and ends, twice damps at once" if arguments.rise else "damps and ends")
    )
    take_news = session.link.take_news if session else None
    end = supervise(runner, robot, print_line, arguments.rise, arguments.yes, take_news)
    if session:
        session.end(lies=end.mode == Mode.PASSIVE)
    result = run_summary(end, robot, generation, runner.real_time)
    write_json(arguments.json, result)
    print_line(closing_text(result))
    if arguments.log is not None:
        _write_log(arguments.log, runner.log(), print_line)
    if end.reason in ("no_state", "wrong_generation"):
        print("surefoot: error:", no_robot_text(where, end, generation), file=sys.stderr)
        return NO_ROBOT
    if end.reason == "not_standing":
        print("surefoot: error:", lying_text(end), file=sys.stderr)
    return 0 if end.stood_to_end else ENDED_DAMPED


def _write_log(file: str, log: RunLog, print_line: Callable[[str], None]) -> None:
    """Write the log if a LowState arrived; print a write error instead of raising it."""
    if not len(log):
        print_line(f"--log: no LowState arrived; {file} is not written")
        return
    try:
        logged_time = write_run_log(file, log)
    except OSError as error:
        print(f"surefoot: error: --log: {error}", file=sys.stderr)
        return
    print_line(f"log of {logged_time:.1f} s: {file}")


def _check_operator(arguments: argparse.Namespace) -> None:
    if arguments.yes and not arguments.rise:
        raise Error(
            "--yes: got no --rise, expected both: --yes lets the robot rise without a key press"
        )
    if arguments.real_robot and not arguments.rise:
        raise Error(
            "--real-robot: got no --rise, expected both: a real robot must start lying, so that "
            "its arming checks run before it gets torques"
        )
    if arguments.real_robot and arguments.no_remote and not has_keyboard():
        raise Error(
            "--real-robot: got --no-remote and no terminal, expected button B of the remote or a "
            "terminal to stop the robot"
        )
    if arguments.rise and not arguments.yes and not has_keyboard():
        raise Error(
            "--rise: got no terminal for the keys, expected a terminal, or --yes to arm and rise "
            "as soon as all checks pass"
        )


def _where(arguments: argparse.Namespace) -> str:
    """Return the address of the robot as text."""
    if arguments.sdk in DDS_ROBOTS:
        return f"rt/lowstate on {arguments.interface}"
    return f"{arguments.host}:{arguments.port}"


def _open_session(
    arguments: argparse.Namespace, print_line: Callable[[str], None]
) -> DdsSession | None:
    """Return the network and the link to a robot that speaks DDS; None: the robot speaks UDP."""
    if arguments.sdk not in DDS_ROBOTS:
        return None
    description = _description(arguments)
    gains = read_gains(arguments.gains, description) or build_robot(description).config.gains
    return DdsSession(arguments, gains.damping_kd, print_line)


def _description(arguments: argparse.Namespace) -> RobotDescription:
    description = chosen_robot(arguments, default=default_robot(arguments.sdk))
    assert description is not None  # not None, because a default robot is given
    name = str(description.table["robot"]["name"])
    if arguments.sdk in DDS_ROBOTS and name in DDS_ROBOTS and name != arguments.sdk:
        raise Error(
            f"--sdk: got {arguments.sdk} with robot {name}, expected {name}: their motors have "
            "different servo modes"
        )
    return description


def _make_runner(
    arguments: argparse.Namespace, session: DdsSession | None
) -> tuple[Runner, Robot, str]:
    description = _description(arguments)
    robot = build_robot(description)
    generation = arguments.sdk or default_generation(robot.name)
    if not 0.0 <= arguments.predict_ms <= 50.0:
        raise Error(f"--predict-ms: got {arguments.predict_ms:g}, expected 0 .. 50 [ms]")
    options = RunOptions(
        rate=arguments.rate,
        duration=math.inf if arguments.duration is None else arguments.duration,
        power_level=arguments.power_level,
        remote=not arguments.no_remote,
        start=Start.LYING if arguments.rise else Start.STANDING,
        operator_timeout=arguments.operator_timeout,
        log_time=0.0 if arguments.log is None else arguments.log_time or LOG_TIME,
    )
    stand = ControllerOptions(
        motor_damping=arguments.motor_damping,
        delay=arguments.predict_ms / 1000.0,
        form=read_form(arguments.form),
    )
    if arguments.power_limit is not None:
        stand.power_limit = arguments.power_limit
    gains = read_gains(arguments.gains, description)
    if session:
        runner = Runner(robot, session.link, gains, stand, options)
        return runner, robot, generation
    runner = Runner(
        robot,
        arguments.host,
        arguments.port,
        generation,
        arguments.local_port,
        gains,
        stand,
        options,
        arguments.real_robot,
    )
    return runner, robot, generation
