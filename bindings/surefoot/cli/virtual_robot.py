"""surefoot robot: simulates a robot that existing SDK programs can control."""

from __future__ import annotations

import argparse
import sys
from typing import TYPE_CHECKING

from surefoot._core import Error
from surefoot.cli.dds_options import DDS_ROBOTS, DEFAULT_DOMAIN, LOOPBACK, default_robot
from surefoot.cli.graphics import choose_graphics
from surefoot.cli.missing_module import missing_module
from surefoot.cli.output_files import check_json_path, write_json
from surefoot.cli.robot_choice import chosen_robot
from surefoot.system.terminal import LinePrinter

if TYPE_CHECKING:
    from surefoot.virtual_robot import VirtualRobotSettings

# [Hz] Default of --log-rate. Chosen: it bounds the size of the file.
LOG_RATE = 100.0
# [Hz] Rate of LowStates. 1000: real robots with UDP; 500: that of Go2 in the vendor's examples.
UDP_RATE, DDS_RATE = 1000.0, 500.0
# [ms] Time without a command after which the motors damp. 100: assumed for the firmware of robots
# with UDP. 20: what a Go2 does is not known, so a short time is assumed, which shows gaps.
UDP_TIMEOUT_MS, DDS_TIMEOUT_MS = 100.0, 20.0


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
    options = RunOptions(
        arguments.bind,
        arguments.port,
        arguments.duration,
        arguments.view,
        arguments.interface or LOOPBACK,
        DEFAULT_DOMAIN if arguments.domain is None else arguments.domain,
        arguments.libddsc or "",
        None if arguments.no_motion_switcher else arguments.sport_mode,
        arguments.untested_libddsc,
    )
    record = run_robot(read_settings(arguments), options, LinePrinter(sys.stdout))
    write_json(arguments.json, record, indent=None)


def read_settings(arguments: argparse.Namespace) -> VirtualRobotSettings:
    """Return the settings that the arguments give; raise Error if an argument is wrong."""
    from surefoot.virtual_robot import VirtualRobotSettings, parse_shake, read_remote_script

    description = chosen_robot(arguments, default=default_robot(arguments.sdk))
    assert description is not None  # not None, because a default robot is given
    uses_dds = arguments.sdk in DDS_ROBOTS
    rate = arguments.rate or (DDS_RATE if uses_dds else UDP_RATE)
    timeout_ms = arguments.timeout_ms
    if timeout_ms is None:
        timeout_ms = DDS_TIMEOUT_MS if uses_dds else UDP_TIMEOUT_MS
    times = {**vars(arguments), "timeout_ms": timeout_ms}
    for name in ("delay_ms", "jitter_ms", "timeout_ms"):
        value = times[name]
        if not value >= 0.0:
            option = name.replace("_", "-")
            raise Error(f"--{option}: got {value:g}, expected 0 or more [ms]")
    log_rate = LOG_RATE if arguments.log_rate is None else arguments.log_rate
    return VirtualRobotSettings(
        robot=description,
        sdk=arguments.sdk,
        rate=rate,
        hung=arguments.hung,
        lying=arguments.lying,
        walking=arguments.walking,
        drop=arguments.drop,
        delay=arguments.delay_ms / 1000.0,
        jitter=arguments.jitter_ms / 1000.0,
        timeout=timeout_ms / 1000.0,
        shakes=tuple(parse_shake(text) for text in arguments.shake),
        remote=read_remote_script(arguments.remote) if arguments.remote else (),
        log_rate=min(log_rate, rate) if arguments.json else 0.0,
        seed=arguments.seed,
    )
