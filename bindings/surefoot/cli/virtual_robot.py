"""surefoot robot: simulates a robot that existing SDK programs can control."""

from __future__ import annotations

import argparse
import sys
from typing import TYPE_CHECKING

from surefoot._core import Error
from surefoot.cli.graphics import choose_graphics
from surefoot.cli.missing_module import missing_module
from surefoot.cli.output_files import check_json_path, write_json
from surefoot.cli.robot_choice import chosen_robot
from surefoot.system.terminal import LinePrinter

if TYPE_CHECKING:
    from surefoot.virtual_robot import VirtualRobotSettings

# [Hz] Default of --log-rate. Chosen: it bounds the size of the file.
LOG_RATE = 100.0


def robot(arguments: argparse.Namespace) -> None:
    """Run a virtual robot until --duration is over, Ctrl-C or SIGTERM.

    Raises:
        Error: A wrong argument.
        OSError: The port is taken or not permitted, or a file could not be written.
    """
    choose_graphics(pictures=arguments.view)
    try:
        from surefoot.virtual_robot import RunOptions, run_robot
    except ModuleNotFoundError as problem:
        raise missing_module("robot", problem) from None
    if arguments.json == "-":
        raise Error("--json: got '-', expected a file: the status lines use stdout")
    check_json_path(arguments.json)
    if arguments.lying:  # print to stderr: programs read the port from the first line of stdout
        print(
            "dropping the robot until it lies with no leg blocking another: some seconds",
            file=sys.stderr,
        )
    options = RunOptions(arguments.bind, arguments.port, arguments.duration, arguments.view)
    record = run_robot(read_settings(arguments), options, LinePrinter(sys.stdout))
    write_json(arguments.json, record, indent=None)


def read_settings(arguments: argparse.Namespace) -> VirtualRobotSettings:
    """Return the settings that the arguments give; raise Error if an argument is wrong."""
    from surefoot.virtual_robot import VirtualRobotSettings, parse_shake, read_remote_script

    description = chosen_robot(arguments, default="go1")
    assert description is not None  # not None, because a default robot is given
    for name in ("delay_ms", "jitter_ms", "timeout_ms"):
        value = getattr(arguments, name)
        if not value >= 0.0:
            option = name.replace("_", "-")
            raise Error(f"--{option}: got {value:g}, expected 0 or more [ms]")
    log_rate = LOG_RATE if arguments.log_rate is None else arguments.log_rate
    return VirtualRobotSettings(
        robot=description,
        sdk=arguments.sdk,
        rate=arguments.rate,
        hung=arguments.hung,
        lying=arguments.lying,
        walking=arguments.walking,
        drop=arguments.drop,
        delay=arguments.delay_ms / 1000.0,
        jitter=arguments.jitter_ms / 1000.0,
        timeout=arguments.timeout_ms / 1000.0,
        shakes=tuple(parse_shake(text) for text in arguments.shake),
        remote=read_remote_script(arguments.remote) if arguments.remote else (),
        log_rate=min(log_rate, arguments.rate) if arguments.json else 0.0,
        seed=arguments.seed,
    )
