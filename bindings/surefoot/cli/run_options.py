"""Options of surefoot run."""

from __future__ import annotations

import argparse

from surefoot.cli.dds_run import add_dds_run_options
from surefoot.cli.robot_choice import add_robot_options
from surefoot.cli.simulation_options import add_form_option

_EPILOG = (
    "exit status: 0 the robot stood, and lay down on request, 1 no robot of the right generation "
    "answered, 2 a wrong argument, 3 any other end: the robot never stood, or a fault made it sit "
    "down or damp"
)


def add_run_options(parser: argparse.ArgumentParser) -> None:
    """Add every option of surefoot run."""
    add_robot_options(parser, "go1")
    parser.epilog = _EPILOG
    add = parser.add_argument
    _add_start_group(parser)
    add("--host", metavar="ADDRESS", help="address of the robot (127.0.0.1)")
    add("--port", type=int, metavar="N", help="UDP port of the robot (8007)")
    add("--local-port", type=int, metavar="N", help="UDP port of this computer (0: any)")
    add(
        "--sdk",
        metavar="GENERATION",
        help="generation of the frames over UDP, or go2 or b2: DDS (the robot's newest)",
    )
    add("--rate", type=float, default=500.0, metavar="HZ", help="rate of the control loop (500)")
    add(
        "--duration",
        type=float,
        metavar="S",
        help="end this long after the robot first stands (never)",
    )
    add(
        "--power-level",
        type=int,
        default=1,
        metavar="N",
        help="level of the power protection, N x 100 W: 1 .. 10; 0 switches it off; a walk needs "
        "2 or more, that of a b1 5 or more (1)",
    )
    add(
        "--power-limit",
        type=float,
        metavar="W",
        help="scale torques so that the motors take less (0.9 of what the level allows)",
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
        help="delay from measurement to action that the controller compensates by prediction (0)",
    )
    add(
        "--operator-timeout",
        type=_stuck_time,
        default=2.0,
        metavar="S",
        help="sit down after the thread that reads keys and signals was stuck for this long, for "
        "example in a terminal that accepts no output (2); 0.5 or more; inf: never",
    )
    add("--log", metavar="FILE.npz", help="write the last ticks at the end of the run")
    add(
        "--log-time",
        type=float,
        metavar="S",
        help="time that --log keeps, up to 600 (60); takes 0.85 MB per second at 500 Hz",
    )
    add("--no-remote", action="store_true", help="ignore the wireless remote")
    add("--json", metavar="FILE|-", help="write the summary as one JSON object; - is stdout")
    add_dds_run_options(parser)


def _stuck_time(text: str) -> float:
    """Parse --operator-timeout [s].

    The value must be at least 0.5 s, because the operator thread also waits while it prints.
    """
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
        help="start with a lying robot: its motors damp while arming checks run; a + Enter arms, "
        "u + Enter rises; at the end the robot sits down. Without --rise, a standing robot is "
        "taken over in its present pose, without arming checks",
    )
    add(
        "--yes",
        action="store_true",
        help="with --rise: arm and rise once, without a key press, as soon as all checks pass",
    )
    add(
        "--real-robot",
        action="store_true",
        help="with --rise: --host may be another machine, and --interface may lead to one. This "
        "software has not been run on "
        "hardware: read docs/first-day.md, hang the robot up, be ready to switch it off",
    )
