"""The options of surefoot run."""

from __future__ import annotations

import argparse

from surefoot.cli.robot_choice import add_robot_options
from surefoot.cli.stand_options import add_form_option

_EPILOG = (
    "exit status: 0 the robot stood, and lay down because it was asked to, 1 no robot of the right "
    "generation answered, 2 a wrong argument, 3 anything else: it never stood, was laid down by a "
    "fault, or let go of"
)


def add_run_options(parser: argparse.ArgumentParser) -> None:
    """Add every option of surefoot run."""
    add_robot_options(parser, "go1")
    parser.epilog = _EPILOG
    add = parser.add_argument
    _add_start_group(parser)
    add("--host", default="127.0.0.1", metavar="ADDRESS", help="of the robot (127.0.0.1)")
    add("--port", type=int, default=8007, metavar="N", help="of the robot (8007)")
    add("--local-port", type=int, default=0, metavar="N", help="ours (0: any)")
    add("--sdk", metavar="GENERATION", help="of its frames (the robot's newest)")
    add("--rate", type=float, default=500.0, metavar="HZ", help="of the control loop (500)")
    add("--duration", type=float, metavar="S", help="of standing, until it ends by itself (never)")
    add(
        "--power-level",
        type=int,
        default=1,
        metavar="N",
        help="of the power protection, N x 100 W: 1 .. 10; 0 switches it off (1: for beginners)",
    )
    add(
        "--power-limit",
        type=float,
        metavar="W",
        help="commands are scaled to take less (0.9 of what the level allows)",
    )
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
    add(
        "--operator-timeout",
        type=_stuck_time,
        default=2.0,
        metavar="S",
        help="lie down when the program that reads keys and signals was stuck for so long, in a "
        "terminal that takes no lines for example (2); 0.5 or more; inf: never",
    )
    add("--log", metavar="FILE.npz", help="keep the last ticks, and write them when it ends")
    add(
        "--log-time",
        type=float,
        metavar="S",
        help="that --log keeps, up to 600 (60): 0.85 MB of memory a second at 500 Hz",
    )
    add("--no-remote", action="store_true", help="do not obey the wireless remote")
    add("--json", metavar="FILE|-", help="write the summary as one JSON object; - is stdout")


def _stuck_time(text: str) -> float:
    """Return a time that a program which looks every 20 ms and prints lines keeps."""
    try:
        value = float(text)
    except ValueError:
        value = 0.0
    if not value >= 0.5:
        raise argparse.ArgumentTypeError(f"got {text}, expected 0.5 [s] or more, or inf")
    return value


def _add_start_group(parser: argparse.ArgumentParser) -> None:
    add = parser.add_argument_group("start").add_argument
    add(
        "--rise",
        action="store_true",
        help="the robot lies: its motors brake while arming checks run; a + Enter arms, u + Enter "
        "gets it up; it lies down again at the end. Without it a robot that stands is taken over "
        "as it stands, unchecked",
    )
    add(
        "--yes",
        action="store_true",
        help="with --rise: arm and rise unasked as soon as all checks pass, once",
    )
    add(
        "--real-robot",
        action="store_true",
        help="with --rise: --host may be beyond this machine. Nothing here has been run on "
        "hardware; read docs/first-day.md, hang the robot up, keep a hand on its switch",
    )
