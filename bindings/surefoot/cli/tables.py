"""surefoot robots and surefoot gains: tables of the known robots and of all gains."""

from __future__ import annotations

import argparse
from collections.abc import Sequence

import numpy as np

from surefoot._core import Gains, gain_table, get_gain
from surefoot.cli.robot_choice import chosen_robot
from surefoot.robot.loading import (
    available_robots,
    build_robot,
    describe_robot,
    robots_without_urdf,
)


def list_robots(arguments: argparse.Namespace) -> None:
    """Print the robots known by name."""
    rows = []
    for name in available_robots():
        description = describe_robot(name)
        robot = build_robot(description)
        source = description.urdf.relative_to(description.mesh_root / "robots")
        rows.append(
            (
                name,
                f"{robot.mass:.1f}",
                _leg_values(robot.config.tau_max),
                _leg_values(robot.config.dq_max),
                str(source),
            )
        )
    print_table(("name", "mass [kg]", "torque [N.m]", "speed [rad/s]", "source"), rows)
    print("\nTorque and speed limits: hip, thigh, calf. Sources: example-robot-data.")
    names = ", ".join(robots_without_urdf())
    print(f"With Unitree's URDF (--robot NAME --urdf FILE): {names}.")


def list_gains(arguments: argparse.Namespace) -> None:
    """Print every gain with its value: of the chosen robot, else the library's default.

    Raises:
        Error: A wrong argument.
    """
    gains = Gains()
    description = chosen_robot(arguments)
    if description is not None:
        gains = build_robot(description).config.gains
    rows = [
        (
            row.name,
            f"{get_gain(gains, row.name):g}",
            row.unit,
            f"{row.minimum:g} .. {row.maximum:g}",
            row.meaning,
        )
        for row in gain_table()
    ]
    print_table(("name", "value", "unit", "range", "meaning"), rows)


def print_table(header: Sequence[str], rows: Sequence[Sequence[str]]) -> None:
    """Print a header and rows in aligned columns."""
    widths = [max(len(line[k]) for line in (header, *rows)) for k in range(len(header))]
    for line in (header, ["-" * width for width in widths], *rows):
        cells = (cell.ljust(width) for cell, width in zip(line, widths, strict=True))
        print("  ".join(cells).rstrip())


def _leg_values(values: np.ndarray) -> str:
    return " ".join(f"{value:.1f}" for value in values[:3])
