"""surefoot export: writes a robot to one file."""

from __future__ import annotations

import argparse

from surefoot._core import Error
from surefoot.cli.robot_choice import chosen_robot
from surefoot.robot.loading import build_robot


def export(arguments: argparse.Namespace) -> None:
    """Write a .robot file for Robot.load() in C++ and Python; raise Error for a wrong argument."""
    description = chosen_robot(arguments, "ROBOT")
    if description is None:
        raise Error("export: got no robot, expected ROBOT, or both --urdf and --config")
    robot = build_robot(description)
    robot.save(arguments.file)
    print(f"{arguments.file}: {robot.name}, {robot.mass:.2f} kg")
