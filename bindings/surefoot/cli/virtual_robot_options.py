"""Options of surefoot robot."""

from __future__ import annotations

import argparse
import math

from surefoot.cli.dds_options import add_dds_options
from surefoot.cli.robot_choice import add_robot_options

_SHAKE_HELP = (
    "JOINT:TORQUE:HZ@TIME[:DURATION]: apply an external sine torque to a joint; JOINT is FR_0 .. "
    "RL_2 or FR_hip .. RL_calf; N.m; s. Example: FR_1:8:5@2.0:3. Repeatable"
)
_REMOTE_HELP = (
    'script of the wireless remote: lines "TIME press A", "TIME release A", "TIME lx 0.5"; '
    "without it the keyboard of the terminal acts as the remote"
)
_EPILOG = (
    "exit status: 0 ended, also by Ctrl-C or SIGTERM; 1 the port is taken or not permitted, or a "
    "file could not be written; 2 a wrong argument. Times are simulated time since the start"
)


def add_virtual_robot_options(parser: argparse.ArgumentParser) -> None:
    """Add every option of surefoot robot."""
    parser.epilog = _EPILOG
    _add_robot_group(parser)
    _add_link_group(parser)
    _add_dds_group(parser)
    add = parser.add_argument_group("disturbances and inputs").add_argument
    add("--shake", action="append", default=[], metavar="SHAKE", help=_SHAKE_HELP)
    add("--remote", metavar="FILE", help=_REMOTE_HELP)
    add("--seed", type=int, default=1, metavar="N", help="seed of all random numbers (1)")
    add = parser.add_argument_group("results").add_argument
    add("--duration", type=float, default=math.inf, metavar="S", help="end after this time (never)")
    add("--json", metavar="FILE", help="at the end, write received commands and states")
    add("--log-rate", type=float, metavar="HZ", help="rate of the log in FILE (100)")


def _add_robot_group(parser: argparse.ArgumentParser) -> None:
    group = parser.add_argument_group("robot")
    add_robot_options(group, "go1")
    add = group.add_argument
    add(
        "--sdk",
        metavar="a1-v3.3|go1-v3.4|go1-v3.8|b1-v3.8|go2|b2",
        help="generation of the frames over UDP, or go2 or b2: DDS (that of the robot; the robot "
        "go2 has none: choose one)",
    )
    add("--rate", type=float, metavar="HZ", help="LowStates per second (1000; DDS: 500)")
    pose = group.add_mutually_exclusive_group()
    pose.add_argument("--hung", action="store_true", help="base fixed level in the air, legs free")
    pose.add_argument(
        "--lying", action="store_true", help="on the ground, random leg pose, no torque"
    )
    add(
        "--walking",
        action="store_true",
        help="sensor errors, soft soles and leg collisions of a walking robot",
    )
    add(
        "--timeout-ms",
        type=float,
        metavar="MS",
        help="the motors damp after this time without a valid command (100; DDS: 20; 0: never)",
    )
    screen = group.add_mutually_exclusive_group()
    screen.add_argument("--view", action="store_true", help="show the robot in a window")
    screen.add_argument("--headless", action="store_true", help="no window (the default)")


def _add_dds_group(parser: argparse.ArgumentParser) -> None:
    group = parser.add_argument_group("DDS (--sdk go2 or b2)")
    add_dds_options(group)
    add = group.add_argument
    add(
        "--sport-mode",
        default="normal",
        choices=("normal", "ai", "advanced"),
        help="mode of the motion switcher at the start (normal)",
    )
    add("--no-motion-switcher", action="store_true", help="nobody answers its requests")


def _add_link_group(parser: argparse.ArgumentParser) -> None:
    add = parser.add_argument_group("link").add_argument
    add("--port", type=int, default=8007, metavar="N", help="UDP port; 0: a free one (8007)")
    add("--bind", default="127.0.0.1", metavar="ADDRESS", help="address to listen on (127.0.0.1)")
    add("--drop", type=float, default=0.0, metavar="PERCENT", help="datagrams lost, each way (0)")
    add("--delay-ms", type=float, default=0.0, metavar="MS", help="delay each way (0)")
    add(
        "--jitter-ms",
        type=float,
        default=0.0,
        metavar="MS",
        help="further delay each way, uniform from 0 to this (0)",
    )
