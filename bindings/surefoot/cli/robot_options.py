"""The options of surefoot robot."""

from __future__ import annotations

import argparse
import math

from surefoot.cli.robot_choice import add_robot_options

_SHAKE_HELP = (
    "JOINT:TORQUE:HZ@TIME[:DURATION]: a hand shakes a joint with a sine; FR_0 .. RL_2 or FR_hip .. "
    "RL_calf; N.m; s. Example: FR_1:8:5@2.0:3. Repeat for more"
)
_REMOTE_HELP = (
    'plays on the wireless remote: lines "TIME press A", "TIME release A", "TIME lx 0.5"; '
    "without it the terminal's keyboard does, if there is one"
)
_EPILOG = (
    "exit status: 0 the end, also by Ctrl-C or SIGTERM; 1 the port is taken or not permitted, or a "
    "file could not be written; 2 a wrong argument. Times are simulated, since the start"
)


def add_virtual_robot_options(parser: argparse.ArgumentParser) -> None:
    """Add every option of surefoot robot."""
    parser.epilog = _EPILOG
    _add_robot_group(parser)
    _add_link_group(parser)
    add = parser.add_argument_group("what happens to it").add_argument
    add("--shake", action="append", default=[], metavar="SHAKE", help=_SHAKE_HELP)
    add("--remote", metavar="FILE", help=_REMOTE_HELP)
    add("--seed", type=int, default=1, metavar="N", help="of every random number (1)")
    add = parser.add_argument_group("results").add_argument
    add("--duration", type=float, default=math.inf, metavar="S", help="end after this (never)")
    add("--json", metavar="FILE", help="write at the end what it received and did")
    add("--log-rate", type=float, metavar="HZ", help="rows of the log in FILE (100)")


def _add_robot_group(parser: argparse.ArgumentParser) -> None:
    group = parser.add_argument_group("robot")
    add_robot_options(group, "go1")
    add = group.add_argument
    add(
        "--sdk",
        metavar="a1-v3.3|go1-v3.4|go1-v3.8|b1-v3.8",
        help="generation of the frames (the robot's own; a go2 has none, so name one)",
    )
    add("--rate", type=float, default=1000.0, metavar="HZ", help="LowStates per second (1000)")
    pose = group.add_mutually_exclusive_group()
    pose.add_argument("--hung", action="store_true", help="base fixed in the air, level, legs free")
    pose.add_argument("--lying", action="store_true", help="on the ground, legs anyhow, no torque")
    add(
        "--timeout-ms",
        type=float,
        default=100.0,
        metavar="MS",
        help="without a valid command for so long the motors damp (100; 0: never)",
    )
    screen = group.add_mutually_exclusive_group()
    screen.add_argument("--view", action="store_true", help="show it in a window")
    screen.add_argument("--headless", action="store_true", help="no window (that is so anyway)")


def _add_link_group(parser: argparse.ArgumentParser) -> None:
    add = parser.add_argument_group("link").add_argument
    add("--port", type=int, default=8007, metavar="N", help="UDP port; 0: a free one (8007)")
    add("--bind", default="127.0.0.1", metavar="ADDRESS", help="to listen on (127.0.0.1)")
    add("--drop", type=float, default=0.0, metavar="PERCENT", help="lost each way (0)")
    add("--delay-ms", type=float, default=0.0, metavar="MS", help="delay each way (0)")
    add(
        "--jitter-ms",
        type=float,
        default=0.0,
        metavar="MS",
        help="further delay each way, uniform from 0 to this (0)",
    )
