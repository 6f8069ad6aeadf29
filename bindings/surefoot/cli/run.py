"""surefoot run: runs the supervisor on a robot, over UDP or DDS."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Callable

from surefoot._core import RunLog, Runner
from surefoot.cli.dds_options import DDS_ROBOTS, LOOPBACK
from surefoot.cli.dds_run import DdsSession
from surefoot.cli.output_files import check_json_path, write_json
from surefoot.cli.run_checks import check_operator, check_transport
from surefoot.cli.run_log import check_log, write_run_log
from surefoot.cli.run_monitor import supervise
from surefoot.cli.run_operator import key_help
from surefoot.cli.run_setup import DEFAULT_HOST, DEFAULT_PORT, RunSetup, read_setup
from surefoot.cli.run_text import (
    closing_text,
    lying_text,
    no_robot_text,
    run_summary,
    slow_simulator_text,
)
from surefoot.system.terminal import LinePrinter

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
    check_transport(arguments)
    check_operator(arguments)
    print_line = LinePrinter(sys.stderr if arguments.json == "-" else sys.stdout)
    setup = read_setup(arguments)
    if arguments.sdk not in DDS_ROBOTS:
        runner = setup.udp_runner(*_udp_address(arguments), arguments.local_port or 0)
        return _control(arguments, setup, runner, print_line)
    # A robot without sport service lies without any command. So everything that can be refused is
    # refused before the session releases the service.
    setup.check()
    with DdsSession(arguments, print_line) as session:
        link = session.open_link(setup.gains.damping_kd)
        runner = setup.dds_runner(link)
        session.begin()
        return _control(arguments, setup, runner, print_line, session, link.take_news)


def _control(
    arguments: argparse.Namespace,
    setup: RunSetup,
    runner: Runner,
    print_line: Callable[[str], None],
    session: DdsSession | None = None,
    take_news: Callable[[], list[str]] | None = None,
) -> int:
    """Run a runner to its end, write the results and end the session; return the exit status."""
    where, generation = _where(arguments), setup.generation
    print_line(
        f"{where}{'' if session else f' from port {runner.local_port}'}, {generation}, "
        f"{arguments.rate:g} Hz, power level {arguments.power_level}; {key_help(arguments.rise)}; "
        "Ctrl-C "
        + ("sits down and ends, twice damps at once" if arguments.rise else "damps and ends")
    )
    end = supervise(runner, setup.robot, print_line, arguments.rise, arguments.yes, take_news)
    result = run_summary(end, setup.robot, generation, runner.real_time)
    write_json(arguments.json, result)
    print_line(closing_text(result))
    if arguments.tick == "arrival" and (hint := slow_simulator_text(result)):
        print_line(hint)
    if arguments.log is not None:
        _write_log(arguments.log, runner.log(), print_line)
    if session:
        session.end(end)
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


def _udp_address(arguments: argparse.Namespace) -> tuple[str, int]:
    """Return host and port of a robot that speaks UDP."""
    host = DEFAULT_HOST if arguments.host is None else arguments.host
    return host, DEFAULT_PORT if arguments.port is None else arguments.port


def _where(arguments: argparse.Namespace) -> str:
    """Return the address of the robot as text."""
    if arguments.sdk in DDS_ROBOTS:
        return f"rt/lowstate on {arguments.interface or LOOPBACK}"
    host, port = _udp_address(arguments)
    return f"{host}:{port}"
