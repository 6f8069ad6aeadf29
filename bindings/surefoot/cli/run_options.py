"""The options of surefoot run."""

from __future__ import annotations

import argparse

from surefoot.cli.robot_choice import add_robot_options
from surefoot.cli.stand_options import add_form_option

RUN_STATUS = (
    "exit status: 0 the robot stood to the end, 1 no robot of the right generation answered, 2 a "
    "wrong argument, 3 it ended damped"
)


def add_run_options(parser: argparse.ArgumentParser) -> None:
    """Add every option of surefoot run."""
    add_robot_options(parser, "go1")
    parser.epilog = RUN_STATUS
    add = parser.add_argument
    add("--host", default="127.0.0.1", metavar="ADDRESS", help="of the robot (127.0.0.1)")
    add("--port", type=int, default=8007, metavar="N", help="of the robot (8007)")
    add("--local-port", type=int, default=0, metavar="N", help="ours (0: any)")
    add("--sdk", metavar="GENERATION", help="of its frames (the robot's newest)")
    add("--rate", type=float, default=500.0, metavar="HZ", help="of the control loop (500)")
    add("--duration", type=float, metavar="S", help="until it ends by itself (never)")
    add(
        "--power-level",
        type=int,
        default=1,
        metavar="N",
        help="of the power protection, N x 100 W: 1 .. 10; 0 switches it off (1: for beginners)",
    )
    add("--power-limit", type=float, metavar="W", help="commands are scaled to take less (none)")
    add("--gains", metavar="FILE.toml", help="gains that differ from the robot's own")
    add(
        "--motor-damping",
        type=float,
        default=0.0,
        metavar="KD",
        help="motor-side damping [N.m.s/rad] (0: pure torque mode)",
    )
    add_form_option(parser)
    add(
        "--predict-ms",
        type=float,
        default=0.0,
        metavar="MS",
        help="delay from measurement to action that the controller predicts across (0)",
    )
    add("--no-remote", action="store_true", help="do not obey the wireless remote")
    add("--json", metavar="FILE|-", help="write the summary as one JSON object; - is stdout")
