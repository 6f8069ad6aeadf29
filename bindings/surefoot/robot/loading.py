"""Loading of robots: by name, or from a TOML with a URDF or a Pinocchio model."""

from __future__ import annotations

import hashlib
import importlib.metadata
import json
from functools import cache
from pathlib import Path
from typing import Any

from surefoot._core import Error, Robot
from surefoot.robot.build_config import build_config, per_motor
from surefoot.robot.description import (
    RobotDescription,
    available_robots,
    describe_robot,
    robots_without_urdf,
)
from surefoot.robot.robot_toml import read_table
from surefoot.robot.srdf import read_disabled_collisions
from surefoot.robot.urdf import Urdf, read_urdf

__all__ = [
    "RobotDescription",
    "available_robots",
    "build_robot",
    "describe_robot",
    "load_pinocchio_model",
    "load_robot",
    "package_digest",
    "per_motor",
    "robot_identity",
    "robots_without_urdf",
]


def load_robot(
    name: str | None = None,
    *,
    urdf: str | Path | None = None,
    model: Any = None,
    config: str | Path | None = None,
) -> Robot:
    """Load a robot by its name, or from a URDF or a Pinocchio model.

    Exactly one of `name`, `urdf` and `model` is given. `urdf` and `model` also need `config`. The
    robots of robots_without_urdf() are loaded by `name` and `urdf`.

    Args:
        name: One of available_robots(); needs the example-robot-data package (extra ``sim``).
        urdf: Path of a URDF.
        model: A pinocchio.Model with a free-flyer root.
        config: Path of a TOML with the values that a URDF or model lacks (see models/).

    Returns:
        The robot, with armature, limits and IMU mount.

    Raises:
        Error: No source or several sources, unknown name, missing file, joint or frame, or
            unknown key.
    """
    sources = {"a name": name, "urdf=": urdf, "model=": model}
    if name in robots_without_urdf() and model is None and config is None:
        return build_robot(describe_robot(name, urdf=urdf))
    given = [source for source, value in sources.items() if value is not None]
    if len(given) != 1 or (name is None) == (config is None):
        got = " and ".join(given + ["config="] * (config is not None)) or "nothing"
        raise Error(
            f"load_robot: got {got}, expected a name, or urdf= and config=, or model= and config="
        )
    if model is None or config is None:
        return build_robot(describe_robot(name, urdf=urdf, config=config))
    import pinocchio

    if not isinstance(model, pinocchio.Model):
        raise Error(f"model: got {type(model).__name__}, expected a pinocchio.Model")
    return _robot_from_model(model, read_table(config))


def load_pinocchio_model(description: RobotDescription) -> Any:
    """Return the URDF as a pinocchio.Model with a free-flyer root.

    Raises:
        Error: The URDF is missing or invalid.
    """
    return _build_model(description, read_urdf(description.urdf, description.table))


def build_robot(description: RobotDescription) -> Robot:
    """Build the Robot of a description.

    Raises:
        Error: The URDF or the SRDF is missing or invalid, or does not match the TOML; or the robot
            cannot stand, see surefoot.Robot.
    """
    urdf = read_urdf(description.urdf, description.table)
    if description.srdf is not None:
        read_disabled_collisions(description.srdf, urdf.links)
    return _robot_from_model(_build_model(description, urdf), description.table)


def robot_identity(description: RobotDescription, robot: Robot) -> dict[str, str]:
    """Return robot name, digest of its files, and version and build of Surefoot, as JSON values."""
    hashed_values = [robot.serialized_model(), repr(description.table), robot.config.foot_radius]
    return {
        "robot": robot.name,
        "robot files": hashlib.sha256(json.dumps(hashed_values).encode()).hexdigest()[:16],
        "version": importlib.metadata.version("surefoot"),
        "build": package_digest(),
    }


@cache
def package_digest() -> str:
    """Return a digest of all .py, .so and .toml files of this package, 16 hexadecimal digits."""
    folder = Path(__file__).parents[1]
    files = [path for path in sorted(folder.rglob("*")) if path.suffix in (".py", ".so", ".toml")]
    digest = hashlib.sha256()
    for path in files:
        digest.update(str(path.relative_to(folder)).encode() + path.read_bytes())
    return digest.hexdigest()[:16]


def _build_model(description: RobotDescription, urdf: Urdf) -> Any:
    import pinocchio

    try:
        return pinocchio.buildModelFromXML(urdf.text, pinocchio.JointModelFreeFlyer())
    except (ValueError, RuntimeError) as problem:
        raise Error(f"URDF '{description.urdf}': Pinocchio rejects it: {problem}") from None


def _robot_from_model(model: Any, table: dict[str, Any]) -> Robot:
    return Robot.from_serialized_model(model.saveToString(), build_config(model, table))
