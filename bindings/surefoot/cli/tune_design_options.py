"""Options of surefoot tune design, and their conversion to settings."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING

from surefoot._core import Error, Gains
from surefoot.cli.robot_choice import add_robot_options, chosen_robot
from surefoot.robot.description import RobotDescription

if TYPE_CHECKING:
    from surefoot.tune.design import DesignSettings, Timing

_GOAL_METAVAR = "FREQ[:DAMPING]"
_AXES = {
    "height": "of the centre of mass",
    "sway": "of the centre of mass, forward and sideways",
    "attitude": "roll and pitch of the base",
    "yaw": "of the base against its feet",
}


def add_options(parser: argparse.ArgumentParser) -> None:
    """Add every option of surefoot tune design."""
    add_robot_options(parser, "go1")
    _add_goal_options(parser)
    _add_loop_options(parser)
    add = parser.add_argument_group("results").add_argument
    add("--toml", metavar="FILE.toml", help="write all gains, for --gains of the other commands")
    add("--json", metavar="FILE|-", help="write gains and margins as one object; - is stdout")
    add("--report", metavar="DIR", help="write maps of the stable gains, and index.html")


def _add_goal_options(parser: argparse.ArgumentParser) -> None:
    add = parser.add_argument_group("desired closed loop").add_argument
    add(
        "--bandwidth",
        metavar=_GOAL_METAVAR,
        help="natural frequency [Hz] and damping ratio of all axes without their own option; "
        "without --bandwidth those axes keep the robot's gains",
    )
    add(
        "--damping",
        type=float,
        default=0.8,
        metavar="ZETA",
        help="damping ratio where FREQ has none (0.8)",
    )
    for name, text in _AXES.items():
        add(f"--{name}", metavar=_GOAL_METAVAR, help=text)
    add(
        "--trust-imu",
        type=float,
        default=1.0,
        metavar="X",
        help="divides push_time, push_dead_band and the initial IMU noise: above 1 the controller "
        "reacts sooner and to smaller pushes, with less margin (1)",
    )
    add(
        "--trust-legs",
        type=float,
        default=1.0,
        metavar="X",
        help="divides the initial noise of stance feet: above 1 the estimator trusts more that "
        "they do not move (1)",
    )
    add("--gains", metavar="FILE.toml", help="start from these instead of the robot's gains")


def _add_loop_options(parser: argparse.ArgumentParser) -> None:
    add = parser.add_argument_group("control loop").add_argument
    add("--rate", type=float, default=500.0, metavar="HZ", help="commands per second (500)")
    add(
        "--delay-ms",
        type=float,
        default=0.0,
        metavar="MS",
        help="additional delay of commands, beyond one period each way (0)",
    )
    add("--motor-lag-ms", type=float, default=2.0, metavar="MS", help="motor time constant (2)")
    add(
        "--joint-friction-scale",
        type=float,
        default=1.0,
        metavar="X",
        help="factor on joint friction, which damps small oscillations; 0: no friction (1)",
    )


def read_settings(arguments: argparse.Namespace) -> DesignSettings:
    """Return the settings that the arguments give; raise Error if an argument is wrong."""
    from surefoot.tune.design.goals import parse_goal
    from surefoot.tune.design.ranges import check_range
    from surefoot.tune.design.settings import DesignSettings
    from surefoot.tune.design.standing_body import FRICTION_SCALE_RANGE

    check_range("--joint-friction-scale", arguments.joint_friction_scale, *FRICTION_SCALE_RANGE)
    robot = chosen_robot(arguments, default="go1")
    assert robot is not None  # not None, because a default robot is given
    goals = {}
    for axis in _AXES:
        own = getattr(arguments, axis)
        text, option = (own, f"--{axis}") if own else (arguments.bandwidth, "--bandwidth")
        if text is not None:
            goals[axis] = parse_goal(option, text, arguments.damping)
    if not goals:
        options = ", ".join(f"--{axis}" for axis in _AXES)
        raise Error(f"got no frequency, expected --bandwidth or one of {options}")
    return DesignSettings(
        robot=robot,
        goals=goals,
        timing=_timing(arguments),
        start=_start(arguments, robot),
        trust_imu=arguments.trust_imu,
        trust_legs=arguments.trust_legs,
        joint_friction_scale=arguments.joint_friction_scale,
    )


def _timing(arguments: argparse.Namespace) -> Timing:
    from surefoot.tune.design.ranges import check_range
    from surefoot.tune.design.timing import (
        MOTOR_LAG_RANGE,
        RATE_RANGE,
        Timing,
        check_requested_delay,
    )

    rate, delay, lag = arguments.rate, arguments.delay_ms, arguments.motor_lag_ms
    # Check here, so that messages use the options' names and units (Hz, ms; the model uses s).
    check_range("--rate", rate, *RATE_RANGE, "Hz")
    check_requested_delay(rate, delay / 1000.0, "--rate", "--delay-ms")
    least, most = (1000.0 * end for end in MOTOR_LAG_RANGE)
    check_range("--motor-lag-ms", lag, least, most, "ms")
    return Timing(rate, delay / 1000.0, lag / 1000.0)


def _start(arguments: argparse.Namespace, robot: RobotDescription) -> Gains | None:
    if arguments.gains is None:
        return None
    from surefoot.robot.gain_files import load_gains
    from surefoot.robot.loading import build_robot

    return load_gains(arguments.gains, build_robot(robot).config.gains)
