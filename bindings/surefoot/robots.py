"""Robots by name, or from a URDF and a TOML of your own."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from surefoot._core import Error, Gains, Robot
from surefoot.robot_files import RobotDescription, available_robots, describe_robot, read_toml
from surefoot.robot_settings import apply_gains, build_config, per_motor

__all__ = [
    "RobotDescription",
    "available_robots",
    "build_robot",
    "describe_robot",
    "load_gains",
    "load_pinocchio_model",
    "load_robot",
    "per_motor",
]


def load_robot(
    name: str | None = None, *, urdf: str | Path | None = None, config: str | Path | None = None
) -> Robot:
    """Load a robot.

    Args:
        name: One of available_robots(); needs the example-robot-data package (extra ``sim``).
        urdf: Or: the path of a URDF ...
        config: ... with the path of a TOML that says what the URDF does not (see models/).

    Returns:
        The robot; armature, limits and IMU mount are in it.

    Raises:
        Error: Unknown name, missing file, joint or frame, a key that does not exist.
    """
    return build_robot(describe_robot(name, urdf=urdf, config=config))


def load_gains(path: str | Path, start: Gains | None = None) -> Gains:
    """Read gains from a TOML file with a ``[gains]`` table (or plain keys).

    Args:
        path: The file.
        start: Gains that keep their value where the file is silent; library defaults if None.

    Raises:
        Error: A key that is no gain, a value that is no number or out of range.
    """
    table = read_toml(Path(path))
    gains = start.__copy__() if start is not None else Gains()
    rows = table["gains"] if set(table) == {"gains"} else table
    if not isinstance(rows, dict):
        raise Error(f"{path}: 'gains' is {rows!r}, expected a table of names and numbers")
    apply_gains(gains, rows, str(path))
    return gains


def load_pinocchio_model(description: RobotDescription) -> Any:
    """Parse the URDF into a pinocchio.Model with a free-flyer root; raises Error."""
    import pinocchio

    if not description.urdf.is_file():
        raise Error(f"URDF not found: got '{description.urdf}', expected a file")
    try:
        return pinocchio.buildModelFromUrdf(str(description.urdf), pinocchio.JointModelFreeFlyer())
    except ValueError as problem:
        raise Error(f"'{description.urdf}' is not a URDF: {problem}") from None


def build_robot(description: RobotDescription) -> Robot:
    """Build the Robot that a description describes; raises Error."""
    model = load_pinocchio_model(description)
    return Robot.from_serialized_model(model.saveToString(), build_config(model, description.table))
