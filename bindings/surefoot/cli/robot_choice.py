"""Options that choose the robot of a command: by name, or from a URDF and a TOML file."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from surefoot._core import Error
from surefoot.robot.description import (
    RobotDescription,
    describe_robot,
    robots_without_urdf,
    settings_file,
)


def add_robot_options(parser: argparse.ArgumentParser | argparse._ArgumentGroup, text: str) -> None:
    """Add --robot, --urdf and --config; `text` names the default robot in the help."""
    parser.add_argument("--robot", metavar="NAME", help=f"see surefoot robots ({text})")
    add_file_options(parser, "--robot")


def add_mjcf_option(parser: argparse.ArgumentParser | argparse._ArgumentGroup) -> None:
    """Add --mjcf."""
    parser.add_argument(
        "--mjcf",
        metavar="FILE.xml",
        help="simulate robot and ground of an MJCF; the controller keeps the model of --robot",
    )


def print_mapping(description: RobotDescription) -> None:
    """Print on stderr what was found in the MJCF; do nothing without one.

    Raises:
        Error: The MJCF is invalid, or a part is missing or not supported.
    """
    if description.mjcf is None:
        return
    from surefoot.sim.mjcf.describe import describe_mjcf

    print(describe_mjcf(description), file=sys.stderr)


def add_file_options(
    parser: argparse.ArgumentParser | argparse._ArgumentGroup, instead: str
) -> None:
    """Add --urdf and --config."""
    text = f"instead of {instead}, a robot of your own"
    parser.add_argument("--urdf", metavar="FILE.urdf", help=text)
    parser.add_argument("--config", metavar="FILE.toml", help="robot settings that the URDF lacks")


def chosen_robot(
    arguments: argparse.Namespace, option: str = "--robot", default: str | None = None
) -> RobotDescription | None:
    """Return the robot that the arguments choose, or the default; None if there is neither.

    Args:
        arguments: Arguments with robot, urdf and config, and of some commands mjcf; each None if
            not given.
        option: Name of the option for the robot's name, used in messages.
        default: Name of the robot if none is chosen.

    Raises:
        Error: A name and files are given (except --urdf for a robot without URDF), one file is
            given without the other, or the robot does not exist.
    """
    description = _described(arguments, option, default)
    mjcf = getattr(arguments, "mjcf", None)
    return description if mjcf is None or description is None else description.with_mjcf(mjcf)


def _described(
    arguments: argparse.Namespace, option: str, default: str | None
) -> RobotDescription | None:
    """Return the robot without its MJCF."""
    files = {"--urdf": arguments.urdf, "--config": arguments.config}
    given = [name for name, value in files.items() if value is not None]
    if arguments.robot in robots_without_urdf():
        return describe_robot(arguments.robot, urdf=arguments.urdf, config=arguments.config)
    # --sdk b2 makes b2 the default, and its URDF comes from the user.
    if arguments.robot is None and given == ["--urdf"] and default in robots_without_urdf():
        return describe_robot(default, urdf=arguments.urdf)
    if arguments.robot is not None and given:
        raise Error(
            f"got {option} '{arguments.robot}' and {' and '.join(given)}, expected {option} for a "
            "known robot or both --urdf and --config for one of your own"
        )
    if len(given) == 1:
        raise Error(f"got {given[0]} alone, expected both --urdf and --config")
    name = None if given else arguments.robot or default
    if name is None and not given:
        return None
    return describe_robot(name, urdf=arguments.urdf, config=arguments.config)


def robot_source(arguments: argparse.Namespace, default: str) -> str | tuple[str, str]:
    """Return the chosen robot for another process: its name, or the paths of its URDF and TOML.

    Args:
        arguments: Arguments that chosen_robot() has accepted.
        default: Name of the robot if none is chosen.
    """
    if arguments.urdf is None:
        return str(arguments.robot or default)
    config = arguments.config or settings_file(arguments.robot)
    return str(Path(arguments.urdf).resolve()), str(Path(config).resolve())
