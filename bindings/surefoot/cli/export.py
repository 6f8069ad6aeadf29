"""surefoot export: a robot as one file."""

from __future__ import annotations

import argparse

from surefoot._core import Error
from surefoot.robots import load_robot


def export(arguments: argparse.Namespace) -> None:
    """Write a .robot file for Robot.load() in C++ and Python; raises Error."""
    own = [arguments.urdf, arguments.config]
    if arguments.robot is None and None in own:
        raise Error("export: give ROBOT, or both --urdf and --config")
    if arguments.robot is not None and own != [None, None]:
        raise Error(f"export: got ROBOT '{arguments.robot}' and a file of your own, expected one")
    robot = load_robot(arguments.robot, urdf=arguments.urdf, config=arguments.config)
    robot.save(arguments.file)
    print(f"{arguments.file}: {robot.name}, {robot.mass:.2f} kg")
